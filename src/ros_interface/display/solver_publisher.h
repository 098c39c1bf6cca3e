#pragma once

#include <vector>

#include <ros/publisher.h>

#include <cable_variation/ComponentDeviations.h>

#include <cable_variation/measures/measure_evaluation.h>
#include <ros_interface/display/marker_channel.h>

namespace ros {
class NodeHandle;
}

namespace cable_variation_ros {

class SolverContext;

class InterferencePublisher;

/// Shows the design in force: ~cables (markers of cables and clips), ~marks/cables (of clips), ~shapes,
/// ~component_deviations and, as ~interference, what distances were measured. While there is no equilibrium
/// the last shape stays on ~cables, greyed.
class SolverPublisher {
 public:
  SolverPublisher(ros::NodeHandle& node, InterferencePublisher& interference);
  /// @param measured all measures of the scene; none without an equilibrium
  void publish(const SolverContext& context, const std::vector<cable_variation::MeasureValue>& measured);

 private:
  MarkerChannel cables_, marks_;
  InterferencePublisher& interference_;
  ros::Publisher shapes_;
  ros::Publisher deviations_;
  cable_variation::ComponentDeviations deviations_shown_;
};

}  // namespace cable_variation_ros
