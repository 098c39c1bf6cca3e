#pragma once

#include <vector>

#include <ros/publisher.h>

#include <cable_variation/Label.h>

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

/// ~interference and ~labels, which several sources share: each shows what it has in place of what it showed
/// before.
class InterferencePublisher {
 public:
  explicit InterferencePublisher(ros::NodeHandle& node);

  /// Measured on the design in force.
  /// @param clips whose names stay readable on ~interference
  /// @param names the same for ~labels
  void showMeasures(std::vector<DistanceMark> marks, const visualization_msgs::MarkerArray& clips,
                    std::vector<cable_variation::Label> names);
  void showEnvelope(InterferenceView view);
  void showRegion(InterferenceView view);
  /// On ~labels alone: what happens along a path.
  void showPath(std::vector<cable_variation::Label> events);

 private:
  void publish();

  MarkerChannel channel_, marks_;
  ros::Publisher labels_;
  std::vector<DistanceMark> measures_;
  visualization_msgs::MarkerArray clips_;
  std::vector<cable_variation::Label> names_, path_;
  InterferenceView envelope_;
  InterferenceView region_;
};

}  // namespace cable_variation_ros
