#include <ros_interface/conversion/component_deviations.h>

#include <ros_interface/conversion/message_conversion.h>
#include <ros_interface/conversion/same_poses.h>

namespace cable_variation_ros {

using cable_variation::Component;
using cable_variation::ComponentPoses;
using cable_variation::DesignValues;
using cable_variation::Pose;
using cable_variation::Scene;

namespace {

// What rounding leaves of a pose times its inverse, a hundred metres from the origin.
constexpr double kSamePosition = 1e-12;     // [m]
constexpr double kSameOrientation = 1e-12;  // [rad]

bool isIdentity(const Pose& pose) {
  return pose.position.norm() <= kSamePosition &&
         pose.orientation.angularDistance(Eigen::Quaterniond::Identity()) <= kSameOrientation;
}

}  // namespace

ComponentPoses componentDeviations(const Scene& scene, const DesignValues& values,
                                   const ComponentPoses& moved, const ComponentPoses& on_tf) {
  ComponentPoses deviations;
  if (values.empty() && same(moved, on_tf)) return deviations;
  const ComponentPoses actual = componentPosesAt(scene, values, moved);
  for (const Component& component : scene.components) {
    const Pose designed = componentPose(scene, component.name, on_tf);
    const Pose deviation = designed.inverse() * actual.at(component.name);
    if (!isIdentity(deviation)) deviations[component.name] = deviation;
  }
  return deviations;
}

cable_variation::ComponentDeviations toMessage(const ComponentPoses& deviations) {
  cable_variation::ComponentDeviations message;
  for (const auto& [component, pose] : deviations) {
    message.components.emplace_back();
    message.components.back().component = component;
    message.components.back().pose = toPose(pose);
  }
  return message;
}

ComponentPoses fromMessage(const cable_variation::ComponentDeviations& message) {
  ComponentPoses deviations;
  for (const cable_variation::ComponentDeviation& each : message.components) {
    deviations[each.component] = fromPose(each.pose, "deviation of component '" + each.component + "'");
  }
  return deviations;
}

}  // namespace cable_variation_ros
