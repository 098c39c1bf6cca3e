#include <ros_interface/live/event_publisher.h>

#include <ros/console.h>
#include <ros/node_handle.h>

#include <ros_interface/node/names.h>

namespace cable_variation_ros {

using cable_variation::CableEvent;

namespace {

constexpr int kQueue = 100;  // for subscribers that are slow

bool isGood(const CableEvent& event) {
  return event.kind == CableEvent::EQUILIBRIUM_BACK || event.kind == CableEvent::LIMIT_KEPT ||
         event.kind == CableEvent::TF_BACK;
}

}  // namespace

EventPublisher::EventPublisher(ros::NodeHandle& node)
    : publisher_(node.advertise<CableEvent>(kEventsTopic, kQueue)) {}

void EventPublisher::publish(const std::vector<CableEvent>& events) {
  for (CableEvent event : events) {
    event.header.frame_id = kWorldFrame;
    if (isGood(event)) {
      ROS_INFO("%s", event.text.c_str());
    } else {
      ROS_WARN("%s", event.text.c_str());
    }
    publisher_.publish(event);
  }
}

}  // namespace cable_variation_ros
