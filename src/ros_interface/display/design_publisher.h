#pragma once

#include <optional>

#include <ros/publisher.h>

#include <ros_interface/context/solver_context.h>

namespace ros {
class NodeHandle;
}

namespace cable_variation_ros {

/// ~design, latched: the scene and the design in force, for whoever shows them too.
class DesignPublisher {
 public:
  explicit DesignPublisher(ros::NodeHandle& node);

  /// Publishes if the scene or the design is another one.
  void contextChanged(const SolverContext& context);

 private:
  ros::Publisher publisher_;
  std::optional<std::size_t> shown_;  ///< SolverContext::designNumber()
};

}  // namespace cable_variation_ros
