#pragma once

#include <functional>
#include <utility>

#include <ros/callback_queue_interface.h>

namespace cable_variation_ros {

/// A task that waits in a queue of callbacks for its turn.
class QueuedCall : public ros::CallbackInterface {
 public:
  explicit QueuedCall(std::function<void()> task) : task_(std::move(task)) {}
  CallResult call() override {
    task_();
    return Success;
  }

 private:
  std::function<void()> task_;
};

}  // namespace cable_variation_ros
