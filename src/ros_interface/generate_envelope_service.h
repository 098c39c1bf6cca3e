#pragma once

#include <ros/callback_queue.h>
#include <ros/service_server.h>
#include <ros/spinner.h>

#include <cable_variation/GenerateEnvelope.h>

namespace ros {
class NodeHandle;
}

namespace cable_variation_ros {

class EnvelopeRunner;

/// ~generate_envelope, on a thread of its own: one call after another, while the node answers others.
class GenerateEnvelopeService {
 public:
  GenerateEnvelopeService(ros::NodeHandle& node, EnvelopeRunner& runner);

 private:
  bool handle(cable_variation::GenerateEnvelopeRequest& request,
              cable_variation::GenerateEnvelopeResponse& response);

  EnvelopeRunner& runner_;
  ros::CallbackQueue queue_;
  ros::ServiceServer server_;
  ros::AsyncSpinner spinner_;
};

}  // namespace cable_variation_ros
