#include <ros_interface/variation_publisher.h>

#include <ros/node_handle.h>

#include <ros_interface/names.h>

namespace cable_variation_ros {

VariationPublisher::VariationPublisher(ros::NodeHandle& node)
    : markers_(node, kVariationTopic),
      legend_(node.advertise<cable_variation::Legend>(kLegendTopic, 1, true)) {}

void VariationPublisher::show(const visualization_msgs::MarkerArray& markers,
                              cable_variation::Legend legend) {
  markers_.publish(markers);
  legend.topic = markers_.topic();
  legend_.publish(legend);
  showing_ = true;
}

void VariationPublisher::clear() {
  if (!showing_) return;
  markers_.publish({});
  legend_.publish(cable_variation::Legend());
  showing_ = false;
}

}  // namespace cable_variation_ros
