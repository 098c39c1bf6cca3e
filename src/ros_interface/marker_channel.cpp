#include <ros_interface/marker_channel.h>

#include <ros/node_handle.h>

#include <ros_interface/names.h>

namespace cable_variation_ros {

using visualization_msgs::Marker;
using visualization_msgs::MarkerArray;

MarkerArray withDeletions(MarkerArray markers, std::set<std::pair<std::string, int>>& shown) {
  std::set<std::pair<std::string, int>> now;
  for (const Marker& marker : markers.markers) now.emplace(marker.ns, marker.id);
  for (const auto& [name, id] : shown) {
    if (now.count({name, id}) != 0) continue;
    Marker gone;
    gone.header.frame_id = kWorldFrame;
    gone.ns = name;
    gone.id = id;
    gone.action = Marker::DELETE;
    gone.pose.orientation.w = 1.0;
    markers.markers.push_back(gone);
  }
  shown = std::move(now);
  return markers;
}

MarkerChannel::MarkerChannel(ros::NodeHandle& node, const std::string& topic)
    : publisher_(node.advertise<MarkerArray>(topic, 1, true)) {}

void MarkerChannel::publish(MarkerArray markers) {
  publisher_.publish(withDeletions(std::move(markers), shown_));
}

}  // namespace cable_variation_ros
