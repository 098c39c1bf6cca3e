#include <ros_interface/display/marker_channel.h>

#include <ros/node_handle.h>

#include <ros_interface/conversion/message_conversion.h>
#include <ros_interface/node/names.h>

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

namespace {

Eigen::Vector3d vectorOf(const geometry_msgs::Point& point) { return {point.x, point.y, point.z}; }

}  // namespace

Marker nearItsPoints(Marker marker) {
  constexpr double kFar = 1000.0;  // [m]; 24 bits are 0.03 mm there
  if (marker.points.empty()) return marker;
  const Eigen::Vector3d origin = vectorOf(marker.points.front());
  if (!(origin.cwiseAbs().maxCoeff() > kFar)) return marker;
  for (geometry_msgs::Point& point : marker.points) point = toPoint(vectorOf(point) - origin);
  const geometry_msgs::Quaternion& q = marker.pose.orientation;
  const Eigen::Quaterniond orientation(q.w, q.x, q.y, q.z);
  const Eigen::Vector3d shift = orientation.norm() > 0.0 ? orientation.normalized() * origin : origin;
  marker.pose.position = toPoint(vectorOf(marker.pose.position) + shift);
  return marker;
}

MarkerChannel::MarkerChannel(ros::NodeHandle& node, const std::string& topic)
    : publisher_(node.advertise<MarkerArray>(topic, 1, true)) {}

void MarkerChannel::publish(MarkerArray markers) {
  for (Marker& marker : markers.markers) marker = nearItsPoints(std::move(marker));
  publisher_.publish(withDeletions(std::move(markers), shown_));
}

}  // namespace cable_variation_ros
