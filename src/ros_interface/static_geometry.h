#pragma once

#include <memory>

#include <ros/node_handle.h>
#include <tf2_ros/static_transform_broadcaster.h>

#include <ros_interface/display/component_display.h>
#include <ros_interface/live/scene_follower.h>
#include <ros_interface/node/node_parameters.h>

namespace cable_variation_ros {

/// The node static_geometry_node: the components that no motion moves, as latched
/// markers and static transforms; those that tf drives have their frames from whoever does. The frame `world`
/// is on tf even if there are none. Shows the scene of its parameter, and then what ~design tells of.
class StaticGeometry {
 public:
  /// Throws what loadScene() throws.
  StaticGeometry(ros::NodeHandle node, const StaticGeometryParameters& parameters);

 private:
  void load(const std::string& address);
  void show(std::shared_ptr<const cable_variation::Scene> scene);

  cable_variation::InputLimits limits_;
  ComponentDisplay display_;
  std::unique_ptr<tf2_ros::StaticTransformBroadcaster> broadcaster_;
  SceneFollower follower_;
};

}  // namespace cable_variation_ros
