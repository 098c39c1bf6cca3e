#pragma once

#include <optional>
#include <string>
#include <vector>

#include <ros/node_handle.h>
#include <ros/publisher.h>

#include <cable_variation/measures/measure_evaluation.h>

namespace cable_variation_ros {

class SolverContext;

/// The figures of the shape in force as it moves, for robots and plots: ~measures, ~reactions, ~reaction/CLIP
/// for each clip on a component and, if asked for, ~live/MEASURE for each measure. All latched, with the
/// stamp of the context.
class LivePublisher {
 public:
  /// @param each_measure publish ~live/MEASURE too
  LivePublisher(const ros::NodeHandle& node, bool each_measure);

  /// @param measured all measures of the scene; none without an equilibrium
  void publish(const SolverContext& context, const std::vector<cable_variation::MeasureValue>& measured);

 private:
  /// Topics of their own for what the scene has.
  void advertise(const SolverContext& context);

  ros::NodeHandle node_;
  bool each_measure_;
  ros::Publisher measures_, reactions_;
  std::optional<std::size_t> design_number_;  ///< that the topics are for
  std::vector<std::string> clips_, values_;   ///< names of those that have topics
  std::vector<std::size_t> mounted_;          ///< clips of `clips_`, indices
  std::vector<ros::Publisher> reaction_of_clip_, value_of_measure_;
};

}  // namespace cable_variation_ros
