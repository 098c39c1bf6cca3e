#include <ros_interface/envelope_publisher.h>

#include <ros/node_handle.h>

#include <ros_interface/names.h>
#include <ros_interface/same_poses.h>
#include <ros_interface/solver_context.h>

namespace cable_variation_ros {

using cable_variation::ComponentPoses;
using cable_variation::EnvelopeMesh;

ComponentPoses without(const std::vector<std::string>& carried, ComponentPoses moved) {
  for (const std::string& name : carried) moved.erase(name);
  return moved;
}

EnvelopePublisher::EnvelopePublisher(ros::NodeHandle& node, InterferencePublisher& interference)
    : markers_(node, kEnvelopeTopic),
      mesh_(node.advertise<EnvelopeMesh>(kEnvelopeMeshTopic, 1, true)),
      interference_(interference) {
  publishNone();
}

bool EnvelopePublisher::fits(const EnvelopeView& view, const SolverContext& context) const {
  return view.design_number == context.designNumber() &&
         same(view.moved, without(view.carried, context.moved()));
}

bool EnvelopePublisher::show(EnvelopeView view, const SolverContext& context) {
  if (!fits(view, context)) return false;
  markers_.publish(std::move(view.markers));
  mesh_.publish(view.mesh);
  interference_.showEnvelope(std::move(view.interference));
  shown_ = {{}, {}, {}, view.design_number, std::move(view.moved), std::move(view.carried)};
  showing_ = true;
  return true;
}

void EnvelopePublisher::contextChanged(const SolverContext& context) {
  if (!showing_ || fits(shown_, context)) return;
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
