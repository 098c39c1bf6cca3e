#pragma once

#include <memory>

#include <cable_variation/SimulateVariationAction.h>

namespace actionlib {
template <typename Action>
class SimpleActionServer;
}
namespace ros {
class NodeHandle;
}

namespace cable_variation_ros {

class SimulationRunner;

/// ~simulate_variation_action: ~simulate_variation with progress; cancelled by the client or by a new goal.
class SimulateVariationServer {
 public:
  SimulateVariationServer(ros::NodeHandle& node, SimulationRunner& runner);
  ~SimulateVariationServer();

 private:
  void execute(const cable_variation::SimulateVariationGoal& goal);

  SimulationRunner& runner_;
  std::unique_ptr<actionlib::SimpleActionServer<cable_variation::SimulateVariationAction>> server_;
};

}  // namespace cable_variation_ros
