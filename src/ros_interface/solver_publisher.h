#pragma once

#include <ros/publisher.h>

#include <cable_variation/ComponentDeviations.h>

#include <ros_interface/marker_channel.h>

namespace ros {
class NodeHandle;
}

namespace cable_variation_ros {

class SolverContext;

/// Shows the design in force: ~cables (markers of cables and clips), ~shapes,
/// ~component_deviations and, as ~interference, what distances were measured.
class SolverPublisher {
 public:
  explicit SolverPublisher(ros::NodeHandle& node);
  void publish(const SolverContext& context);

 private:
  MarkerChannel cables_;
  MarkerChannel interference_;
  ros::Publisher shapes_;
  ros::Publisher deviations_;
  cable_variation::ComponentDeviations deviations_shown_;
};

}  // namespace cable_variation_ros
