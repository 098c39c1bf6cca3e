#pragma once

#include <vector>

#include <ros_interface/display/marker_channel.h>
#include <ros_interface/markers/interference_markers.h>

namespace ros {
class NodeHandle;
}

namespace cable_variation_ros {

/// What is too close, or where it is closest, from one source.
struct InterferenceView {
  std::vector<DistanceMark> marks;
  std::vector<visualization_msgs::Marker> triangles;
};

/// ~interference, which several sources share: each shows what it has in place of what it showed before.
class InterferencePublisher {
 public:
  explicit InterferencePublisher(ros::NodeHandle& node);

  /// Measured on the design in force. @param clips whose names stay readable
  void showMeasures(std::vector<DistanceMark> marks, const visualization_msgs::MarkerArray& clips);
  void showEnvelope(InterferenceView view);
  void showRegion(InterferenceView view);

 private:
  void publish();

  MarkerChannel channel_;
  std::vector<DistanceMark> measures_;
  visualization_msgs::MarkerArray clips_;
  InterferenceView envelope_;
  InterferenceView region_;
};

}  // namespace cable_variation_ros
