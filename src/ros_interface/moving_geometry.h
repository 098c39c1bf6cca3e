#pragma once

#include <memory>
#include <set>
#include <string>

#include <ros/node_handle.h>
#include <ros/publisher.h>
#include <ros/service_server.h>
#include <ros/subscriber.h>
#include <ros/timer.h>
#include <std_srvs/SetBool.h>
#include <tf2_ros/static_transform_broadcaster.h>
#include <tf2_ros/transform_broadcaster.h>

#include <cable_variation/MotionState.h>
#include <cable_variation/Seek.h>

#include <cable_variation/scene/scene.h>
#include <ros_interface/display/component_display.h>
#include <ros_interface/live/joint_state_follower.h>
#include <ros_interface/live/motion_player.h>
#include <ros_interface/live/scene_follower.h>
#include <ros_interface/node/node_parameters.h>

namespace cable_variation_ros {

/// The node moving_geometry_node: plays the scene's motions on tf, and shows the
/// components they move (and those that ride on them) as latched markers. The links of robots follow joint
/// states. Plays the scene of its parameter, and then what ~design tells of.
class MovingGeometry {
 public:
  /// Throws what loadScene() throws, and std::invalid_argument if two motions
  /// move the same component.
  MovingGeometry(ros::NodeHandle node, const MovingGeometryParameters& parameters);

 private:
  void load(const std::string& address);
  void take(cable_variation::Scene scene);
  void showStaticFrames(const std::set<std::string>& moving);
  void followJoints(const sensor_msgs::JointState& message);
  void tellUnheard();
  void publishState();
  void tick(const ros::TimerEvent& event);
  void sendTransforms();
  bool play(std_srvs::SetBoolRequest& request, std_srvs::SetBoolResponse& response);
  bool seek(cable_variation::SeekRequest& request, cable_variation::SeekResponse& response);

  ros::NodeHandle node_;
  MovingGeometryParameters parameters_;
  std::shared_ptr<const cable_variation::Scene> scene_;
  std::unique_ptr<MotionPlayer> player_;
  bool halted_before_ = false;  ///< by who could not know that the solver has yet to tell of its scene
  std::unique_ptr<JointStateFollower> joints_;
  ros::Subscriber joint_states_;  ///< while there are joints to follow
  ros::WallTime taken_;           ///< the scene; zero: unheard joints have been told
  ComponentDisplay components_;
  std::unique_ptr<tf2_ros::StaticTransformBroadcaster> static_broadcaster_;
  tf2_ros::TransformBroadcaster broadcaster_;
  ros::Publisher state_;
  cable_variation::MotionState told_;
  ros::WallTime told_at_;
  ros::ServiceServer play_server_;
  ros::ServiceServer seek_server_;
  ros::Time last_;  ///< transforms sent
  ros::Timer timer_;
  SceneFollower follower_;
};

}  // namespace cable_variation_ros
