#include <ros_interface/markers/cable_markers.h>

#include <algorithm>
#include <cmath>

#include <ros_interface/markers/marker_colours.h>
#include <ros_interface/node/names.h>

namespace cable_variation_ros {

using cable_variation::Cable;
using cable_variation::CableShape;

namespace {

constexpr double kLargestBend = 2.0 * M_PI / 180.0;  // of one segment [rad]: invisible in RViz's light
constexpr double kStep = 0.001;                      // at which the shape is looked at [m]
constexpr std::size_t kMostSteps = 4000;

constexpr char kSegment[] = "package://cable_variation/meshes/cable_segment.obj";

/// Closes the end at `end`; `inside` is a point of the centreline next to it.
void addLid(MarkerGroup& group, const Eigen::Vector3d& end, const Eigen::Vector3d& inside, double radius) {
  // A little thinner than the cable, so as not to show through its side.
  group.addCylinder(end, end + 0.1 * radius * (inside - end).normalized(), 0.99 * radius);
}

}  // namespace

void addCable(MarkerGroup& group, const CableShape& shape, const Cable& cable, const CableLook& look) {
  const auto radiusAt = [&](double s) { return look.thickness * sectionAt(cable, s).radius; };
  const auto paint = [&](double s) {
    if (look.color) group.setColor(look.color(s));
  };
  const auto wanted = static_cast<std::size_t>(std::ceil(cable.length / kStep)) + 1;
  const std::size_t count = std::clamp<std::size_t>(wanted, 2, kMostSteps);
  const std::vector<cable_variation::Pose> poses = shape.sample(count);
  const double step = cable.length / static_cast<double>(count - 1);

  std::size_t start = 0;
  Eigen::Vector3d first_direction = poses[1].position - poses[0].position;
  for (std::size_t i = 1; i < count; ++i) {
    const bool last = i + 1 == count;
    if (!last) {
      const Eigen::Vector3d next = poses[i + 1].position - poses[i].position;
      const double bend = std::atan2(first_direction.cross(next).norm(), first_direction.dot(next));
      if (bend < kLargestBend && static_cast<double>(i + 1 - start) * step <= look.longest_segment) continue;
      first_direction = next;
    }
    const double middle = 0.5 * static_cast<double>(start + i) * step;
    const double radius = radiusAt(middle);
    paint(middle);
    // Neighbours overlap on the outside of the bend, where cut ends would gape.
    const Eigen::Vector3d span = poses[i].position - poses[start].position;
    const double overlap = 3.0 * kLargestBend * radius;  // a sixth of it closes the largest bend
    const double before = start == 0 ? 0.0 : overlap;
    const double length = span.norm() + before + (last ? 0.0 : overlap);
    cable_variation::Pose segment;
    segment.position = poses[start].position - before * span.normalized();
    segment.orientation = Eigen::Quaterniond::FromTwoVectors(Eigen::Vector3d::UnitX(), span);
    group.addMeshResource(segment, kSegment, {length, radius, radius});
    start = i;
  }
  paint(0.0);
  addLid(group, poses[0].position, poses[1].position, radiusAt(0.0));
  paint(cable.length);
  addLid(group, poses[count - 1].position, poses[count - 2].position, radiusAt(cable.length));
}

visualization_msgs::MarkerArray cableMarkers(const cable_variation::Equilibrium& equilibrium,
                                             const cable_variation::Harness& harness, bool outdated) {
  visualization_msgs::MarkerArray array;
  if (!equilibrium.converged()) return array;
  for (std::size_t i = 0; i < equilibrium.shapes.size(); ++i) {
    MarkerGroup group(kCableMarkers + harness.cables[i].name, kWorldFrame,
                      outdated ? kOutdatedGrey : cableColour(i));
    addCable(group, equilibrium.shapes[i], harness.cables[i], {});
    array.markers.insert(array.markers.end(), group.markers().begin(), group.markers().end());
  }
  return array;
}

}  // namespace cable_variation_ros
