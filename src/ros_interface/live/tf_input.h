#pragma once

#include <atomic>
#include <functional>

#include <ros/callback_queue.h>
#include <ros/node_handle.h>
#include <ros/spinner.h>
#include <ros/subscriber.h>
#include <tf2_msgs/TFMessage.h>
#include <tf2_ros/buffer.h>

namespace cable_variation_ros {

/// tf as it arrives, in a thread of its own. Other than tf2_ros::TransformListener it tells of each message
/// when all of it is in the buffer: what moves together is seen together.
class TfInput {
 public:
  /// @param arrived called from that thread after each message; must not block
  explicit TfInput(std::function<void()> arrived);
  ~TfInput() { stop(); }
  /// Waits for a message that is being taken; afterwards none is.
  void stop() { spinner_.stop(); }

  const tf2_ros::Buffer& buffer() const { return buffer_; }
  /// How often the clock was set back: the buffer was then emptied.
  std::size_t timesBack() const { return times_back_; }

 private:
  void take(const tf2_msgs::TFMessage& message, bool is_static);

  std::function<void()> arrived_;
  tf2_ros::Buffer buffer_;
  std::atomic<std::size_t> times_back_{0};
  ros::Time last_;
  ros::CallbackQueue queue_;
  ros::Subscriber moving_, static_;
  ros::AsyncSpinner spinner_;
};

}  // namespace cable_variation_ros
