#include <ros_interface/live/joint_state_follower.h>

#include <cmath>

#include <cable_variation/util/name_list.h>
#include <cable_variation/util/quantity.h>
#include <ros_interface/conversion/message_conversion.h>

namespace cable_variation_ros {

using cable_variation::didYouMean;
using cable_variation::LinkJoint;
using cable_variation::shortNumber;

namespace {

const ros::Duration kTick(0, 1);  // [s], the shortest

}  // namespace

JointStateFollower::JointStateFollower(const cable_variation::Scene& scene) {
  for (const cable_variation::Component& component : scene.components) {
    if (!component.joint) continue;
    const LinkJoint& joint = *component.joint;
    if (joint.type == LinkJoint::Type::fixed || joint.name != joint.driver) others_.insert(joint.name);
    if (joint.type == LinkJoint::Type::fixed) continue;
    links_[joint.driver].push_back({component.name, component.parent, component.pose, joint});
  }
  for (const auto& entry : links_) joints_.push_back(entry.first);
}

std::vector<geometry_msgs::TransformStamped> JointStateFollower::take(const sensor_msgs::JointState& message,
                                                                      const ros::Time& now,
                                                                      std::vector<std::string>& warnings) {
  std::vector<geometry_msgs::TransformStamped> transforms;
  if (now < last_) {
    heard_.clear();
    waited_ = ros::Time();
  }
  last_ = now;
  const ros::Time stamp = message.header.stamp.isZero() ? now : message.header.stamp;
  if (message.position.size() != message.name.size()) {
    if (!message.position.empty() && told_.insert("").second) {
      warnings.push_back("a message has " + std::to_string(message.position.size()) + " positions for " +
                         std::to_string(message.name.size()) + " joints; expected as many");
    }
    return transforms;  // without any it tells of velocities or efforts only
  }
  for (std::size_t i = 0; i < message.name.size(); ++i) {
    const std::string& name = message.name[i];
    const auto found = links_.find(name);
    if (found == links_.end()) {
      if (others_.count(name) == 0 && told_.insert(name).second) {
        warnings.push_back("joint '" + name + "' is of no robot in the scene" + didYouMean(name, joints_));
      }
      continue;
    }
    if (!isGood(name, message.position[i], warnings)) continue;
    const auto [heard, first] = heard_.emplace(name, stamp);
    if (!first && stamp <= heard->second) continue;
    heard->second = stamp;
    const ros::Time shown = first && stamp <= waited_ ? waited_ + kTick : stamp;
    for (const Link& link : found->second) {
      checkLimits(link, message.position[i], warnings);
      transforms.push_back(
          toTransform(linkPose(link.joint, message.position[i]), link.parent, link.name, shown));
    }
  }
  return transforms;
}

bool JointStateFollower::isGood(const std::string& joint, double position,
                                std::vector<std::string>& warnings) {
  if (std::isfinite(position)) return true;
  if (told_.insert(joint + " is not finite").second) {
    warnings.push_back("joint '" + joint + "' is at " + shortNumber(position) +
                       "; expected a finite position: it stays where it was");
  }
  return false;
}

void JointStateFollower::checkLimits(const Link& link, double driver_position,
                                     std::vector<std::string>& warnings) {
  const LinkJoint& joint = link.joint;
  const double position = jointPosition(joint, driver_position);
  if (position >= joint.lower && position <= joint.upper) return;
  if (!told_.insert(joint.name + " is out of its limits").second) return;
  warnings.push_back("joint '" + joint.name + "' is at " + shortNumber(position) + ", out of its limits " +
                     shortNumber(joint.lower) + " to " + shortNumber(joint.upper) + "; it is followed");
}

std::vector<geometry_msgs::TransformStamped> JointStateFollower::waiting(const ros::Time& now) {
  waited_ = now;
  std::vector<geometry_msgs::TransformStamped> transforms;
  for (const auto& [joint, links] : links_) {
    if (heard_.count(joint) != 0) continue;
    for (const Link& link : links) transforms.push_back(toTransform(link.pose, link.parent, link.name, now));
  }
  return transforms;
}

std::vector<std::string> JointStateFollower::unheard() const {
  std::vector<std::string> names;
  for (const std::string& joint : joints_) {
    if (heard_.count(joint) == 0) names.push_back(joint);
  }
  return names;
}

}  // namespace cable_variation_ros
