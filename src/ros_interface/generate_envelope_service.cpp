#include <ros_interface/generate_envelope_service.h>

#include <ros/node_handle.h>

#include <ros_interface/envelope_runner.h>
#include <ros_interface/names.h>

namespace cable_variation_ros {

GenerateEnvelopeService::GenerateEnvelopeService(ros::NodeHandle& node, EnvelopeRunner& runner)
    : runner_(runner), spinner_(1, &queue_) {
  ros::NodeHandle own(node);
  own.setCallbackQueue(&queue_);
  server_ = own.advertiseService(kGenerateEnvelopeService, &GenerateEnvelopeService::handle, this);
  spinner_.start();
}

bool GenerateEnvelopeService::handle(cable_variation::GenerateEnvelopeRequest& request,
                                     cable_variation::GenerateEnvelopeResponse& response) {
  response = runner_.run(request, [](const RunProgress&) { return ros::ok(); });
  return true;
}

}  // namespace cable_variation_ros
