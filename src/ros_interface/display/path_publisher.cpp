#include <ros_interface/display/path_publisher.h>

#include <utility>

#include <ros/node_handle.h>

#include <ros_interface/context/solver_context.h>
#include <ros_interface/node/names.h>

namespace cable_variation_ros {

PathPublisher::PathPublisher(ros::NodeHandle& node) : channel_(node, kPathCheckTopic) {
  channel_.publish({});
}

void PathPublisher::show(visualization_msgs::MarkerArray markers, std::size_t design_number,
                         const SolverContext& context) {
  if (design_number != context.designNumber()) return;
  channel_.publish(std::move(markers));
  design_number_ = design_number;
  showing_ = true;
}

void PathPublisher::contextChanged(const SolverContext& context) {
  if (!showing_ || context.designNumber() == design_number_) return;
  channel_.publish({});
  showing_ = false;
}

}  // namespace cable_variation_ros
