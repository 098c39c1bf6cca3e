#include <ros_interface/markers/clearance_markers.h>

#include <algorithm>
#include <cstdio>
#include <map>

#include <cable_variation/envelope/clearance/clearance_limit.h>
#include <cable_variation/measures/component_parts.h>
#include <ros_interface/markers/marker_colours.h>
#include <ros_interface/markers/marker_shapes.h>
#include <ros_interface/node/names.h>

namespace cable_variation_ros {

using cable_variation::Component;
using cable_variation::EnvelopeClearance;
using cable_variation::Pose;
using cable_variation::Scene;
using cable_variation::TriangleMesh;
using visualization_msgs::Marker;

namespace {

constexpr double kLift = 3e-4;  // [m]; beyond what RViz's depth buffer tells apart at a metre

/// Bodies of two cables hold shapes that do not occur together; only what is judged together does.
bool interferes(const Scene& scene, const EnvelopeClearance& clearance) {
  const double least = std::max(lowerLimit(scene, clearance).value_or(0.0), 0.0);
  const bool apart = clearance.other && clearance.kind == EnvelopeClearance::Kind::bodies;
  return (apart ? clearance.worst_sample : clearance.distance) < least;
}

DistanceMark toMark(const Scene& scene, const EnvelopeClearance& clearance, const std::string& other,
                    bool moving) {
  DistanceMark mark;
  mark.marker_namespace = kClearanceMarkers + scene.harness.cables[clearance.cable].name + "/" + other;
  mark.point = clearance.on_envelope;
  mark.other = clearance.on_other;
  mark.text = "envelope of " + scene.harness.cables[clearance.cable].name + " - " + other + " " +
              distanceText(clearance.distance, clearance.arc_length);
  if (moving) {
    char time[32];
    std::snprintf(time, sizeof time, ", t = %.2f s", clearance.time);
    mark.text += time;
  }
  mark.interferes = interferes(scene, clearance);
  return mark;
}

}  // namespace

std::vector<DistanceMark> clearanceMarks(const Scene& scene, const std::vector<EnvelopeClearance>& clearances,
                                         bool moving) {
  const auto otherOf = [&](const EnvelopeClearance& each) {
    return each.other ? scene.harness.cables[*each.other].name : each.component;
  };
  std::map<std::string, const EnvelopeClearance*> closest;
  for (const EnvelopeClearance& each : clearances) {
    const EnvelopeClearance*& best = closest[otherOf(each)];
    if (best == nullptr || each.distance < best->distance) best = &each;
  }
  std::vector<DistanceMark> marks;
  for (const EnvelopeClearance& each : clearances) {
    const std::string other = otherOf(each);
    const bool worth = closest[other] == &each && each.distance >= 0.0 && each.distance <= kWorthShowing;
    if (worth || interferes(scene, each)) marks.push_back(toMark(scene, each, other, moving));
  }
  return marks;
}

std::vector<std::uint32_t> collidingTriangles(const std::vector<EnvelopeClearance>& clearances,
                                              const std::string& component) {
  std::vector<std::uint32_t> all;
  for (const EnvelopeClearance& each : clearances) {
    if (each.component == component) all.insert(all.end(), each.colliding.begin(), each.colliding.end());
  }
  std::sort(all.begin(), all.end());
  all.erase(std::unique(all.begin(), all.end()), all.end());
  return all;
}

std::vector<Marker> triangleMarkers(const std::string& marker_namespace, const std::string& frame,
                                    const TriangleMesh& mesh, const std::vector<std::uint32_t>& triangles,
                                    const Pose& pose) {
  if (triangles.empty()) return {};
  TriangleMesh red;
  for (const std::uint32_t number : triangles) {
    const auto& corners = mesh.triangles.at(number);
    const Eigen::Vector3d& a = mesh.vertices[corners[0]];
    const Eigen::Vector3d& b = mesh.vertices[corners[1]];
    const Eigen::Vector3d& c = mesh.vertices[corners[2]];
    const Eigen::Vector3d lift = kLift * (b - a).cross(c - a).normalized();
    for (const double side : {1.0, -1.0}) {
      const auto first = static_cast<std::uint32_t>(red.vertices.size());
      for (const Eigen::Vector3d& corner : {a, b, c}) red.vertices.push_back(corner + side * lift);
      red.triangles.push_back(side > 0.0 ? std::array<std::uint32_t, 3>{first, first + 1, first + 2}
                                         : std::array<std::uint32_t, 3>{first, first + 2, first + 1});
    }
  }
  MarkerGroup group(marker_namespace, frame, kInterferenceRed);
  group.addMesh(pose, red);
  group.lockToFrame();
  return group.markers();
}

std::vector<Marker> triangleMarkers(const Component& component, const std::vector<std::uint32_t>& triangles,
                                    const Pose& deviation) {
  if (triangles.empty()) return {};
  return triangleMarkers(kTriangleMarkers + component.name, component.name, mergedMesh(component), triangles,
                         deviation);
}

}  // namespace cable_variation_ros
