#pragma once

#include <string>
#include <vector>

#include <cable_variation/scene/motion.h>

namespace cable_variation_ros {

/// Reads a component's motion from a rosbag into its samples, in the frame `parent`, times from 0.
/// `topic` holds geometry_msgs/PoseStamped, PoseWithCovarianceStamped,
/// TransformStamped or tf2_msgs/TFMessage (the transforms whose child frame is
/// `frame`); empty: /tf. Times are the header's, or the recorder's where the
/// header has none; of poses at the same time the last one counts. Throws
/// std::invalid_argument that names the file, and the topic, frame or message: not a bag,
/// topic or frame not in it, another type, another parent frame, a time before that of
/// the pose before, a pose that is none.
void readBagMotion(const std::string& path, const std::string& topic, const std::string& frame,
                   const std::string& parent, cable_variation::Motion& motion);

}  // namespace cable_variation_ros
