#include <ros_interface/markers/component_variation_markers.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

#include <ros_interface/conversion/message_conversion.h>
#include <ros_interface/markers/colour_map.h>
#include <ros_interface/markers/coloured_mesh.h>
#include <ros_interface/node/names.h>

namespace cable_variation_ros {

using cable_variation::Component;
using cable_variation::ComponentPoses;
using cable_variation::ComponentVariation;
using cable_variation::Pose;
using cable_variation::Scene;
using Eigen::Vector3d;
using visualization_msgs::Marker;

namespace {

constexpr double kMillimetres = 1e3;
constexpr double kLift = 1e-4;           // covers the part where it is shown in its own colour [m]
constexpr double kTextHeight = 0.016;    // [m]
constexpr double kSmallestShift = 1e-6;  // of a mean that is worth a note [m]

/// Six sigma of each vertex of each visual [m].
std::vector<std::vector<double>> sixSigmas(const Component& component, const ComponentVariation& variation,
                                           const Pose& pose) {
  std::vector<std::vector<double>> all;
  for (const cable_variation::Visual& visual : component.visuals) {
    std::vector<double>& values = all.emplace_back();
    if (!visual.mesh) continue;
    const Pose placed = pose * visual.pose;
    values.reserve(visual.mesh->vertices.size());
    for (const Vector3d& vertex : visual.mesh->vertices) {
      values.push_back(variationAt(variation, placed * vertex).six_sigma);
    }
  }
  return all;
}

double largestOf(const std::vector<std::vector<double>>& values) {
  double largest = 0.0;
  for (const std::vector<double>& some : values) {
    for (const double value : some) largest = std::max(largest, value);
  }
  return largest;
}

Marker blank(const Component& component, int id, int type, const Pose& pose) {
  Marker marker;
  marker.header.frame_id = component.name;
  marker.frame_locked = true;
  marker.ns = kVariationMarkers + component.name;
  marker.id = id;
  marker.type = type;
  marker.pose = toPose(pose);
  marker.scale.x = marker.scale.y = marker.scale.z = 1.0;
  marker.color.r = marker.color.g = marker.color.b = marker.color.a = 1.0F;
  return marker;
}

std::string millimetres(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.2f mm", kMillimetres * value);
  return text;
}

/// Above the part and in front of it, as it stands in the world.
Marker label(const Component& component, int id, const Pose& deviation, const Pose& pose, double largest) {
  Vector3d low = Vector3d::Constant(HUGE_VAL), high = Vector3d::Constant(-HUGE_VAL);
  for (const cable_variation::Visual& visual : component.visuals) {
    if (!visual.mesh) continue;
    const Pose placed = pose * visual.pose;
    for (const Vector3d& vertex : visual.mesh->vertices) {
      low = low.cwiseMin(placed * vertex);
      high = high.cwiseMax(placed * vertex);
    }
  }
  const Vector3d place(high.x(), 0.5 * (low.y() + high.y()), high.z() + kTextHeight);
  Pose at = deviation;
  at.position = deviation * (pose.inverse() * place);
  Marker marker = blank(component, id, Marker::TEXT_VIEW_FACING, at);
  marker.scale.z = kTextHeight;
  marker.text = component.name + ": up to " + millimetres(largest);
  return marker;
}

}  // namespace

ComponentVariationView componentVariationMarkers(const Scene& scene,
                                                 const std::vector<ComponentVariation>& variations,
                                                 const ComponentPoses& poses,
                                                 const ComponentPoses& deviations) {
  std::vector<std::vector<std::vector<double>>> values;
  double largest = 0.0, largest_shift = 0.0;
  for (const ComponentVariation& variation : variations) {
    const Component& component = scene.components.at(variation.component);
    values.push_back(sixSigmas(component, variation, poses.at(component.name)));
    largest = std::max(largest, largestOf(values.back()));
    largest_shift = std::max(largest_shift,
                             largestVariation(scene, variation, poses.at(component.name)).mean_shift.norm());
  }

  ComponentVariationView view;
  const ColourScale scale(0.0, largest);
  for (std::size_t i = 0; i < variations.size(); ++i) {
    const Component& component = scene.components[variations[i].component];
    const Pose& pose = poses.at(component.name);
    const auto found = deviations.find(component.name);
    const Pose deviation = found == deviations.end() ? Pose() : found->second;
    Marker mesh = blank(component, 0, Marker::TRIANGLE_LIST, deviation);
    for (std::size_t k = 0; k < component.visuals.size(); ++k) {
      const cable_variation::Visual& visual = component.visuals[k];
      if (!visual.mesh) continue;
      std::vector<Vector3d> colors;
      colors.reserve(values[i][k].size());
      for (const double value : values[i][k]) colors.push_back(scale(value));
      addColouredMesh(*visual.mesh, visual.pose, (pose * visual.pose).orientation, colors, kLift, mesh);
    }
    if (mesh.points.empty()) continue;
    view.markers.markers.push_back(mesh);
    view.markers.markers.push_back(label(component, 1, deviation, pose, largestOf(values[i])));
  }
  if (view.markers.markers.empty()) return view;

  view.legend.title = "Variation of parts";
  view.legend.quantity = "6 sigma in the direction that varies most";
  view.legend.unit = "mm";
  view.legend.maximum = kMillimetres * largest;
  if (largest_shift > kSmallestShift) {
    view.legend.note = "Means are off the design by up to " + millimetres(largest_shift) +
                       " where parts vary most; 6 sigma does not contain that.";
  }
  return view;
}

}  // namespace cable_variation_ros
