#include <ros_interface/tf_follower.h>

#include <ros/console.h>
#include <ros/node_handle.h>

#include <ros_interface/message_conversion.h>
#include <ros_interface/names.h>
#include <ros_interface/solver_context.h>

namespace cable_variation_ros {

using cable_variation::ComponentPoses;
using cable_variation::Pose;

namespace {

// Closer than this two poses are the same: what a transform loses on its way through tf.
constexpr double kSamePosition = 1e-9;     // [m]
constexpr double kSameOrientation = 1e-9;  // [rad]

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

}  // namespace

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
