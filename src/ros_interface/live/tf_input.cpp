#include <ros_interface/live/tf_input.h>

#include <utility>

#include <ros/console.h>
#include <tf2/exceptions.h>

namespace cable_variation_ros {

namespace {

constexpr int kQueue = 100;  // messages, as tf2_ros has it

}  // namespace

TfInput::TfInput(std::function<void()> arrived) : arrived_(std::move(arrived)), spinner_(1, &queue_) {
  ros::NodeHandle node;
  node.setCallbackQueue(&queue_);
  using Message = tf2_msgs::TFMessage;
  moving_ = node.subscribe<Message>("/tf", kQueue,
                                    [this](const Message::ConstPtr& message) { take(*message, false); });
  static_ = node.subscribe<Message>("/tf_static", kQueue,
                                    [this](const Message::ConstPtr& message) { take(*message, true); });
  spinner_.start();
}

void TfInput::take(const tf2_msgs::TFMessage& message, bool is_static) {
  const ros::Time now = ros::Time::now();
  if (now < last_) {
    buffer_.clear();
    ++times_back_;
  }
  last_ = now;
  for (const geometry_msgs::TransformStamped& transform : message.transforms) {
    try {
      buffer_.setTransform(transform, "tf", is_static);
    } catch (const tf2::TransformException& error) {
      ROS_WARN_THROTTLE(5.0, "tf of '%s': %s", transform.child_frame_id.c_str(), error.what());
    }
  }
  arrived_();
}

}  // namespace cable_variation_ros
