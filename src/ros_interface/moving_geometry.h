#pragma once

#include <vector>

#include <ros/node_handle.h>
#include <ros/service_server.h>
#include <ros/timer.h>
#include <std_srvs/SetBool.h>
#include <tf2_ros/static_transform_broadcaster.h>
#include <tf2_ros/transform_broadcaster.h>

#include <cable_variation/Seek.h>

#include <cable_variation/scene/scene.h>
#include <ros_interface/display/component_display.h>
#include <ros_interface/live/motion_player.h>
#include <ros_interface/node/node_parameters.h>

namespace cable_variation_ros {

/// The node moving_geometry_node: plays the scene's motions on tf, and shows the
/// components they move (and those that ride on them) as latched markers.
class MovingGeometry {
 public:
  /// Throws what loadScene() throws, and std::invalid_argument if two motions
  /// move the same component.
  MovingGeometry(ros::NodeHandle node, const MovingGeometryParameters& parameters);

 private:
  void tick(const ros::TimerEvent& event);
  void sendTransforms();
  bool play(std_srvs::SetBoolRequest& request, std_srvs::SetBoolResponse& response);
  bool seek(cable_variation::SeekRequest& request, cable_variation::SeekResponse& response);

  cable_variation::Scene scene_;
  MotionPlayer player_;
  ComponentDisplay components_;
  tf2_ros::StaticTransformBroadcaster static_broadcaster_;
  tf2_ros::TransformBroadcaster broadcaster_;
  ros::ServiceServer play_server_;
  ros::ServiceServer seek_server_;
  ros::Time last_;  ///< transforms sent
  ros::Timer timer_;
};

}  // namespace cable_variation_ros
