#pragma once

#include <memory>

#include <ros/node_handle.h>
#include <tf2_ros/static_transform_broadcaster.h>

#include <ros_interface/display/component_display.h>
#include <ros_interface/node/node_parameters.h>

namespace cable_variation_ros {

/// The node static_geometry_node: the components that no motion moves, as latched
/// markers and static transforms. The frame `world` is on tf even if there are none.
class StaticGeometry {
 public:
  /// Throws what loadScene() throws.
  StaticGeometry(ros::NodeHandle node, const StaticGeometryParameters& parameters);

 private:
  cable_variation::Scene scene_;
  std::unique_ptr<ComponentDisplay> display_;
  tf2_ros::StaticTransformBroadcaster broadcaster_;
};

}  // namespace cable_variation_ros
