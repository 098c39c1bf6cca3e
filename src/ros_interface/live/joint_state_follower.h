#pragma once

#include <map>
#include <set>
#include <string>
#include <vector>

#include <geometry_msgs/TransformStamped.h>
#include <ros/time.h>
#include <sensor_msgs/JointState.h>

#include <cable_variation/scene/scene.h>

namespace cable_variation_ros {

/// Where joint states put the links of a scene's robots.
class JointStateFollower {
 public:
  explicit JointStateFollower(const cable_variation::Scene& scene);

  /// Whether the scene has joints that move.
  bool hasJoints() const { return !links_.empty(); }

  /// Links in their parents' frames whose joints a message tells of, with its stamp (`now`, if it has none).
  /// A joint that it tells of again with the same or an older stamp is left out, until the clock is set back.
  /// The first that is heard of a joint is stamped after all that waiting() told of it: tf takes the newest.
  /// @param warnings takes what is wrong with the message: each joint is told of once
  std::vector<geometry_msgs::TransformStamped> take(const sensor_msgs::JointState& message,
                                                    const ros::Time& now, std::vector<std::string>& warnings);

  /// Links whose joints no message has told of, where the scene has them, with the stamp `now`.
  std::vector<geometry_msgs::TransformStamped> waiting(const ros::Time& now);
  /// Joints that no message has told of.
  std::vector<std::string> unheard() const;

 private:
  struct Link {
    std::string name, parent;
    cable_variation::Pose pose;  // in the scene
    cable_variation::LinkJoint joint;
  };
  bool isGood(const std::string& joint, double position, std::vector<std::string>& warnings);
  void checkLimits(const Link& link, double driver_position, std::vector<std::string>& warnings);

  std::map<std::string, std::vector<Link>> links_;  // by the joint whose position counts
  std::vector<std::string> joints_;                 // whose positions count
  std::set<std::string> others_;                    // joints that are fixed or mimic one
  std::map<std::string, ros::Time> heard_;          // newest stamp, by joint
  std::set<std::string> told_;                      // joints, by what was wrong
  ros::Time last_;                                  // now, when a message was taken
  ros::Time waited_;                                // newest stamp of waiting()
};

}  // namespace cable_variation_ros
