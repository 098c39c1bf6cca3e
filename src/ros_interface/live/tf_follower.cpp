#include <ros_interface/live/tf_follower.h>

#include <ros/console.h>
#include <ros/node_handle.h>

#include <ros_interface/context/solver_context.h>
#include <ros_interface/conversion/message_conversion.h>
#include <ros_interface/conversion/same_poses.h>
#include <ros_interface/node/names.h>

namespace cable_variation_ros {

using cable_variation::ComponentPoses;
using cable_variation::Pose;

TfFollower::TfFollower(ros::NodeHandle& node, SolverContext& context, double rate_hz)
    : context_(context), listener_(buffer_, node) {
  timer_ = node.createWallTimer(ros::WallDuration(1.0 / rate_hz),
                                [this](const ros::WallTimerEvent&) { follow(); });
}

ComponentPoses TfFollower::posesOnTf() const {
  ComponentPoses moved;
  const cable_variation::Scene& scene = context_.design().scene;
  for (const cable_variation::Component& component : scene.components) {
    if (!buffer_.canTransform(kWorldFrame, component.name, ros::Time(0))) continue;
    const geometry_msgs::TransformStamped transform =
        buffer_.lookupTransform(kWorldFrame, component.name, ros::Time(0));
    const Pose pose = fromTransform(transform.transform, "tf frame '" + component.name + "'");
    if (!same(pose, componentPose(scene, component.name))) moved[component.name] = pose;
  }
  return moved;
}

void TfFollower::follow() {
  try {
    const ComponentPoses moved = posesOnTf();
    if (!same(moved, context_.moved())) context_.move(moved);
  } catch (const std::exception& error) {
    ROS_WARN_THROTTLE(5.0, "live: %s", error.what());
  }
}

}  // namespace cable_variation_ros
