#pragma once

#include <vector>

#include <ros/publisher.h>

#include <cable_variation/CableEvent.h>

namespace ros {
class NodeHandle;
}

namespace cable_variation_ros {

/// ~events, and the same in the log.
class EventPublisher {
 public:
  explicit EventPublisher(ros::NodeHandle& node);

  void publish(const std::vector<cable_variation::CableEvent>& events);

 private:
  ros::Publisher publisher_;
};

}  // namespace cable_variation_ros
