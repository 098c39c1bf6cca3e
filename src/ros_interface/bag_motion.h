#pragma once

#include <string>
#include <vector>

#include <cable_variation/scene/motion.h>

namespace cable_variation_ros {

/// A component's motion from a rosbag, in the frame `parent`, times from 0.
/// `topic` holds geometry_msgs/PoseStamped, PoseWithCovarianceStamped,
/// TransformStamped or tf2_msgs/TFMessage (the transforms whose child frame is
/// `frame`); empty: /tf. Times are the header's, or the recorder's where the
/// header has none. Throws std::invalid_argument that names the file, and the
/// topic, frame or message: not a bag, topic or frame not in it, another type,
/// another parent frame, a time that does not increase, a pose that is none.
/// A transform repeated with the same time and pose is taken once.
std::vector<cable_variation::TimedPose> readBagMotion(const std::string& path, const std::string& topic,
                                                      const std::string& frame, const std::string& parent);

}  // namespace cable_variation_ros
