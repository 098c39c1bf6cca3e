#include <ros_interface/display/path_publisher.h>

#include <algorithm>
#include <string>
#include <utility>

#include <ros/node_handle.h>

#include <ros_interface/context/solver_context.h>
#include <ros_interface/display/interference_publisher.h>
#include <ros_interface/node/names.h>

namespace cable_variation_ros {

using visualization_msgs::Marker;
using visualization_msgs::MarkerArray;

PathPublisher::PathPublisher(ros::NodeHandle& node, InterferencePublisher& labels)
    : channel_(node, kPathCheckTopic),
      marks_(node, std::string(kMarksTopics) + kPathCheckTopic),
      labels_(labels) {
  publish({}, {});
}

void PathPublisher::show(const MarkerArray& markers, std::vector<cable_variation::Label> events,
                         std::size_t design_number, const SolverContext& context) {
  if (design_number != context.designNumber()) return;
  publish(markers, std::move(events));
  design_number_ = design_number;
  showing_ = true;
}

void PathPublisher::contextChanged(const SolverContext& context) {
  if (!showing_ || context.designNumber() == design_number_) return;
  publish({}, {});
  showing_ = false;
}

void PathPublisher::publish(const MarkerArray& markers, std::vector<cable_variation::Label> events) {
  channel_.publish(markers);
  MarkerArray marks = markers;
  std::vector<Marker>& all = marks.markers;
  const auto is_text = [](const Marker& marker) { return marker.type == Marker::TEXT_VIEW_FACING; };
  all.erase(std::remove_if(all.begin(), all.end(), is_text), all.end());
  marks_.publish(std::move(marks));
  labels_.showPath(std::move(events));
}

}  // namespace cable_variation_ros
