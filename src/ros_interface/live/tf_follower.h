#pragma once

#include <ros/wall_timer.h>
#include <tf2_ros/buffer.h>
#include <tf2_ros/transform_listener.h>

#include <cable_variation/scene/scene.h>

namespace ros {
class NodeHandle;
}

namespace cable_variation_ros {

class SolverContext;

/// Moves the context's components to where tf has them. A component that is not
/// on tf stays where the scene puts it.
class TfFollower {
 public:
  TfFollower(ros::NodeHandle& node, SolverContext& context, double rate_hz);

 private:
  void follow();
  cable_variation::ComponentPoses posesOnTf() const;

  SolverContext& context_;
  tf2_ros::Buffer buffer_;
  tf2_ros::TransformListener listener_;
  ros::WallTimer timer_;
};

}  // namespace cable_variation_ros
