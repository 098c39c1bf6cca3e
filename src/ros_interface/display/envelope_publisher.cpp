#include <ros_interface/display/envelope_publisher.h>

#include <ros/node_handle.h>

#include <ros_interface/node/names.h>

namespace cable_variation_ros {

using cable_variation::EnvelopeMesh;

EnvelopePublisher::EnvelopePublisher(ros::NodeHandle& node, InterferencePublisher& interference)
    : markers_(node, kEnvelopeTopic),
      mesh_(node.advertise<EnvelopeMesh>(kEnvelopeMeshTopic, 1, true)),
      interference_(interference) {
  publishNone();
}

bool EnvelopePublisher::show(EnvelopeView view, const SolverContext& context) {
  if (!view.origin.fits(context)) return false;
  markers_.publish(std::move(view.markers));
  mesh_.publish(view.mesh);
  interference_.showEnvelope(std::move(view.interference));
  shown_ = std::move(view.origin);
  showing_ = true;
  return true;
}

void EnvelopePublisher::contextChanged(const SolverContext& context) {
  if (!showing_ || shown_.fits(context)) return;
  publishNone();
  interference_.showEnvelope({});
  showing_ = false;
}

void EnvelopePublisher::publishNone() {
  markers_.publish({});
  EnvelopeMesh none;
  none.header.frame_id = kWorldFrame;
  mesh_.publish(none);
}

}  // namespace cable_variation_ros
