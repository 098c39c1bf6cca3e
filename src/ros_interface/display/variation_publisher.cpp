#include <ros_interface/display/variation_publisher.h>

#include <algorithm>

#include <ros/node_handle.h>

#include <ros_interface/display/tube_publisher.h>
#include <ros_interface/node/names.h>

namespace cable_variation_ros {

using visualization_msgs::Marker;
using visualization_msgs::MarkerArray;

namespace {

/// Without the cables.
MarkerArray marksOf(MarkerArray markers) {
  const auto of_cable = [](const Marker& marker) {
    return marker.type == Marker::MESH_RESOURCE || marker.type == Marker::CYLINDER;
  };
  std::vector<Marker>& all = markers.markers;
  all.erase(std::remove_if(all.begin(), all.end(), of_cable), all.end());
  return markers;
}

}  // namespace

VariationPublisher::VariationPublisher(ros::NodeHandle& node, TubePublisher& tubes)
    : markers_(node, kVariationTopic),
      marks_(node, std::string(kMarksTopics) + kVariationTopic),
      legend_(node.advertise<cable_variation::Legend>(kLegendTopic, 1, true)),
      tubes_(tubes) {}

void VariationPublisher::show(const MarkerArray& markers, cable_variation::CableTubes tubes,
                              cable_variation::Legend legend, std::function<void()> renew) {
  markers_.publish(markers);
  marks_.publish(marksOf(markers));
  tubes_.setVariation(std::move(tubes));
  if (!renewing_) tubes_.publishAgain();
  legend.topic = markers_.topic();
  legend_.publish(legend);
  renew_ = std::move(renew);
  showing_ = true;
}

void VariationPublisher::hide() {
  if (!showing_) return;
  markers_.publish({});
  marks_.publish({});
  tubes_.setVariation({});
  if (!renewing_) tubes_.publishAgain();
  legend_.publish(cable_variation::Legend());
  showing_ = false;
}

void VariationPublisher::clear() {
  hide();
  renew_ = nullptr;
}

void VariationPublisher::contextChanged() {
  renewing_ = true;
  if (renew_) {
    const std::function<void()> renew = renew_;  // it may show another view, with another way to renew it
    renew();
  } else {
    hide();
  }
  renewing_ = false;
}

}  // namespace cable_variation_ros
