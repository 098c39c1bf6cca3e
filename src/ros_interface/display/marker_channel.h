#pragma once

#include <set>
#include <string>
#include <utility>

#include <ros/publisher.h>
#include <visualization_msgs/MarkerArray.h>

namespace ros {
class NodeHandle;
}

namespace cable_variation_ros {

/// A latched topic of markers that deletes what the last message showed and the
/// next one does not.
class MarkerChannel {
 public:
  MarkerChannel(ros::NodeHandle& node, const std::string& topic);

  /// `markers` is all there is to be seen.
  void publish(visualization_msgs::MarkerArray markers);

  std::string topic() const { return publisher_.getTopic(); }

 private:
  ros::Publisher publisher_;
  std::set<std::pair<std::string, int>> shown_;
};

/// The same marker, with its points seen from one of them if they are more than a kilometre from its
/// pose: RViz draws points in single precision, which in map coordinates is centimetres. Seen from a
/// fixed frame nearby it then draws them exactly.
visualization_msgs::Marker nearItsPoints(visualization_msgs::Marker marker);

/// `markers`, and a DELETE for each namespace and id of `shown` that is not among
/// them. `shown` becomes what is there afterwards.
visualization_msgs::MarkerArray withDeletions(visualization_msgs::MarkerArray markers,
                                              std::set<std::pair<std::string, int>>& shown);

}  // namespace cable_variation_ros
