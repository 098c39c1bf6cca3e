#include <ros_interface/display/tube_publisher.h>

#include <ros/node_handle.h>

#include <ros_interface/context/solver_context.h>
#include <ros_interface/markers/cable_tubes.h>
#include <ros_interface/node/names.h>

namespace cable_variation_ros {

using cable_variation::CableTubes;

TubePublisher::TubePublisher(ros::NodeHandle& node)
    : publisher_(node.advertise<CableTubes>(kTubesTopic, 1, true)) {}

void TubePublisher::setVariation(CableTubes variation) { variation_ = std::move(variation); }

void TubePublisher::publish(const SolverContext& context) {
  tubes_ = cableTubes(context.lastShape(), context.harness(), !context.equilibrium().converged());
  tubes_.header.stamp = context.stamp();
  publishAgain();
}

void TubePublisher::publishAgain() {
  CableTubes all = tubes_;
  addValues(all, variation_);
  publisher_.publish(all);
}

}  // namespace cable_variation_ros
