#include <ros_interface/conversion/bag_recording.h>

#include <set>
#include <stdexcept>

#include <geometry_msgs/PoseStamped.h>
#include <geometry_msgs/PoseWithCovarianceStamped.h>
#include <geometry_msgs/TransformStamped.h>
#include <rosbag/bag.h>
#include <rosbag/view.h>
#include <tf2_msgs/TFMessage.h>

#include <cable_variation/scene/motion_samples.h>
#include <ros_interface/conversion/message_conversion.h>

namespace cable_variation_ros {

using cable_variation::Motion;
using cable_variation::MotionSamples;
using cable_variation::Pose;

namespace {

std::string withoutSlash(const std::string& frame) {
  return !frame.empty() && frame.front() == '/' ? frame.substr(1) : frame;
}

std::string listOf(const std::set<std::string>& names) {
  std::string text;
  for (const std::string& name : names) text += (text.empty() ? "" : ", ") + name;
  return text.empty() ? "none" : text;
}

/// Gathers the poses of one frame, message by message.
class Recording {
 public:
  Recording(const std::string& frame, const std::string& parent) : frame_(frame), parent_(parent) {}

  void add(const rosbag::MessageInstance& message) {
    recorded_ = message.getTime();
    if (const auto pose = message.instantiate<geometry_msgs::PoseStamped>()) {
      addPose(pose->header, fromPose(pose->pose, where()));
    } else if (const auto uncertain = message.instantiate<geometry_msgs::PoseWithCovarianceStamped>()) {
      addPose(uncertain->header, fromPose(uncertain->pose.pose, where()));
    } else if (const auto transform = message.instantiate<geometry_msgs::TransformStamped>()) {
      addTransform(*transform);
    } else if (const auto transforms = message.instantiate<tf2_msgs::TFMessage>()) {
      for (const geometry_msgs::TransformStamped& each : transforms->transforms) addTransform(each);
    } else {
      throw std::invalid_argument("is of type " + message.getDataType() +
                                  ", expected geometry_msgs/PoseStamped, PoseWithCovarianceStamped, "
                                  "TransformStamped or tf2_msgs/TFMessage");
    }
  }

  void finish(Motion& motion) const {
    if (poses_ == 0) {
      throw std::invalid_argument("no frame '" + frame_ + "'; frames there: " + listOf(others_));
    }
    samples_.finish(motion);
  }

 private:
  std::string where() const { return "pose " + std::to_string(poses_ + 1); }

  void addTransform(const geometry_msgs::TransformStamped& transform) {
    if (withoutSlash(transform.child_frame_id) == frame_) {
      addPose(transform.header, fromTransform(transform.transform, where()));
    } else {
      others_.insert(transform.child_frame_id);
    }
  }

  void addPose(const std_msgs::Header& header, const Pose& pose) {
    if (withoutSlash(header.frame_id) != parent_) {
      throw std::invalid_argument(where() + " is in frame '" + header.frame_id + "', expected '" + parent_ +
                                  "', the frame of the component's parent");
    }
    const ros::Time stamp = header.stamp.isZero() ? recorded_ : header.stamp;
    if (poses_ == 0) start_ = stamp;
    try {
      samples_.add((stamp - start_).toSec(), pose);
    } catch (const std::invalid_argument& error) {
      throw std::invalid_argument(where() + ": " + error.what());
    }
    ++poses_;
  }

  std::string frame_;
  std::string parent_;
  ros::Time recorded_;
  ros::Time start_;
  MotionSamples samples_;
  std::size_t poses_ = 0;
  std::set<std::string> others_;
};

}  // namespace

void readBagHere(const std::string& path, const std::string& topic, const std::string& frame,
                 const std::string& parent, Motion& motion) {
  const std::string name = topic.empty() ? "/tf" : topic;
  try {
    rosbag::Bag bag(path, rosbag::bagmode::Read);
    rosbag::View view(bag, rosbag::TopicQuery(name));
    if (view.size() == 0) {
      std::set<std::string> topics;
      rosbag::View everything(bag);
      for (const rosbag::ConnectionInfo* connection : everything.getConnections()) {
        topics.insert(connection->topic);
      }
      throw std::invalid_argument("is not there; topics there: " + listOf(topics));
    }
    Recording recording(frame, parent);
    for (const rosbag::MessageInstance& message : view) recording.add(message);
    recording.finish(motion);
  } catch (const rosbag::BagUnindexedException&) {
    throw std::invalid_argument("bag '" + path + "': has no index, as when a recording ends early; " +
                                "rosbag reindex makes one");
  } catch (const rosbag::BagException& error) {
    throw std::invalid_argument("bag '" + path + "': " + error.what());
  } catch (const ros::Exception& error) {  // a message that does not fit its type
    throw std::invalid_argument("bag '" + path + "', topic '" + name + "': " + error.what());
  } catch (const std::invalid_argument& error) {
    throw std::invalid_argument("bag '" + path + "', topic '" + name + "': " + error.what());
  }
}

}  // namespace cable_variation_ros
