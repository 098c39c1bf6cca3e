#include <ros_interface/display/variation_publisher.h>

#include <ros/node_handle.h>

#include <ros_interface/node/names.h>

namespace cable_variation_ros {

VariationPublisher::VariationPublisher(ros::NodeHandle& node)
    : markers_(node, kVariationTopic),
      legend_(node.advertise<cable_variation::Legend>(kLegendTopic, 1, true)) {}

void VariationPublisher::show(const visualization_msgs::MarkerArray& markers, cable_variation::Legend legend,
                              std::function<void()> renew) {
  markers_.publish(markers);
  legend.topic = markers_.topic();
  legend_.publish(legend);
  renew_ = std::move(renew);
  showing_ = true;
}

void VariationPublisher::hide() {
  if (!showing_) return;
  markers_.publish({});
  legend_.publish(cable_variation::Legend());
  showing_ = false;
}

void VariationPublisher::clear() {
  hide();
  renew_ = nullptr;
}

void VariationPublisher::contextChanged() {
  if (!renew_) {
    hide();
    return;
  }
  const std::function<void()> renew = renew_;  // it may show another view, with another way to renew it
  renew();
}

}  // namespace cable_variation_ros
