#include <ros_interface/conversion/same_poses.h>

namespace cable_variation_ros {

using cable_variation::ComponentPoses;
using cable_variation::Pose;

namespace {

constexpr double kSamePosition = 1e-9;     // [m]
constexpr double kSameOrientation = 1e-9;  // [rad]

}  // namespace

bool same(const Pose& a, const Pose& b) {
  return (a.position - b.position).norm() <= kSamePosition &&
         a.orientation.angularDistance(b.orientation) <= kSameOrientation;
}

bool same(const ComponentPoses& a, const ComponentPoses& b) {
  if (a.size() != b.size()) return false;
  for (const auto& [name, pose] : a) {
    const auto found = b.find(name);
    if (found == b.end() || !same(pose, found->second)) return false;
  }
  return true;
}

}  // namespace cable_variation_ros
