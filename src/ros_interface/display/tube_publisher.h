#pragma once

#include <ros/publisher.h>

#include <cable_variation/CableTubes.h>

namespace ros {
class NodeHandle;
}

namespace cable_variation_ros {

class SolverContext;

/// ~tubes, latched: the cables in force for displays, with the variation that is shown of them.
class TubePublisher {
 public:
  explicit TubePublisher(ros::NodeHandle& node);

  /// Variation of cables, none if empty; to be seen from the next message on.
  void setVariation(cable_variation::CableTubes variation);
  /// The shapes in force, or the last ones.
  void publish(const SolverContext& context);
  /// Those published last, with the variation there is now.
  void publishAgain();

 private:
  ros::Publisher publisher_;
  cable_variation::CableTubes tubes_;  ///< without variation
  cable_variation::CableTubes variation_;
};

}  // namespace cable_variation_ros
