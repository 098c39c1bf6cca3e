#pragma once

#include <ros/publisher.h>
#include <visualization_msgs/MarkerArray.h>

#include <cable_variation/Legend.h>

#include <ros_interface/marker_channel.h>

namespace ros {
class NodeHandle;
}

namespace cable_variation_ros {

/// One view at a time on ~variation, and on ~legend what its colours mean.
class VariationPublisher {
 public:
  explicit VariationPublisher(ros::NodeHandle& node);

  void show(const visualization_msgs::MarkerArray& markers, cable_variation::Legend legend);

  /// The view no longer fits what else is shown.
  void clear();

 private:
  MarkerChannel markers_;
  ros::Publisher legend_;
  bool showing_ = false;
};

}  // namespace cable_variation_ros
