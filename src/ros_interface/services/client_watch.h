#pragma once

#include <map>
#include <mutex>
#include <string>

#include <actionlib/action_definition.h>
#include <boost/function.hpp>
#include <ros/message_event.h>
#include <ros/node_handle.h>
#include <ros/single_subscriber_publisher.h>

namespace cable_variation_ros {

/// Whether the client that sent an action its newest goal is still there: one that has listened to results,
/// and does no more, has gone. Who never listened, such as `rostopic pub`, is not missed. Safe from several
/// threads.
template <typename Action>
class ClientWatch {
  ACTION_DEFINITION(Action)

 public:
  /// To be made before the action's server, so that it hears of a goal first. The node's queue calls it back.
  ClientWatch(ros::NodeHandle& node, const std::string& action) {
    constexpr int kQueue = 50;  // as of actionlib's server, which shares the topic
    using Link = ros::SingleSubscriberPublisher;
    const boost::function<void(const Link&)> come = [this](const Link& link) { count(link, 1); };
    const boost::function<void(const Link&)> go = [this](const Link& link) { count(link, -1); };
    results_ = node.advertise<ActionResult>(action + "/result", kQueue, come, go);
    goals_ = node.subscribe(action + "/goal", kQueue, &ClientWatch::hear, this);
  }

  bool hasGone() const {
    const std::lock_guard<std::mutex> lock(mutex_);
    return listened_ && listeners_.count(sender_) == 0;
  }

  std::string sender() const {
    const std::lock_guard<std::mutex> lock(mutex_);
    return sender_;
  }

 private:
  void count(const ros::SingleSubscriberPublisher& link, int change) {
    const std::lock_guard<std::mutex> lock(mutex_);
    const std::string name = link.getSubscriberName();
    if ((listeners_[name] += change) <= 0) listeners_.erase(name);
    if (change > 0 && name == sender_) listened_ = true;
  }

  void hear(const ros::MessageEvent<ActionGoal const>& event) {
    const std::lock_guard<std::mutex> lock(mutex_);
    sender_ = event.getPublisherName();
    listened_ = listeners_.count(sender_) > 0;
  }

  mutable std::mutex mutex_;
  std::map<std::string, int> listeners_;  ///< to results: their nodes' names, and how often
  std::string sender_;                    ///< of the newest goal
  bool listened_ = false;                 ///< it, since then
  ros::Publisher results_;
  ros::Subscriber goals_;
};

}  // namespace cable_variation_ros
