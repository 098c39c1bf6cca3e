#pragma once

#include <memory>

#include <cable_variation/GenerateEnvelopeAction.h>

namespace actionlib {
template <typename Action>
class SimpleActionServer;
}
namespace ros {
class NodeHandle;
}

namespace cable_variation_ros {

class EnvelopeRunner;

/// ~generate_envelope_action: ~generate_envelope with progress; cancelled by the client or by a new goal.
class GenerateEnvelopeServer {
 public:
  GenerateEnvelopeServer(ros::NodeHandle& node, EnvelopeRunner& runner);
  ~GenerateEnvelopeServer();

 private:
  void execute(const cable_variation::GenerateEnvelopeGoal& goal);

  EnvelopeRunner& runner_;
  std::unique_ptr<actionlib::SimpleActionServer<cable_variation::GenerateEnvelopeAction>> server_;
};

}  // namespace cable_variation_ros
