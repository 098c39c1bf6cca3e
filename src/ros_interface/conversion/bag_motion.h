#pragma once

#include <string>

#include <cable_variation/scene/motion.h>
#include <cable_variation/util/input_limits.h>

namespace cable_variation_ros {

/// Reads a component's motion from a rosbag into its samples, in the frame `parent`, times from 0.
/// `topic` holds geometry_msgs/PoseStamped, PoseWithCovarianceStamped,
/// TransformStamped or tf2_msgs/TFMessage (the transforms whose child frame is
/// `frame`); empty: /tf. Times are the header's, or the recorder's where the
/// header has none; of poses at the same time the last one counts. Throws
/// std::invalid_argument that names the file, and the topic, frame or message: not a bag,
/// topic or frame not in it, another type, another parent frame, a time before that of
/// the pose before, a pose that is none, more poses than the limits allow.
/// The bag is read by the program bag_importer, within the limits import_seconds and import_memory: whatever
/// the file is, this process lives on.
void readBagMotion(const std::string& path, const std::string& topic, const std::string& frame,
                   const std::string& parent, cable_variation::Motion& motion,
                   const cable_variation::InputLimits& limits = {});

/// A motion's poses as bytes, for a process on the same machine.
std::string bytesOf(const cable_variation::Motion& motion);
/// And back into the samples of a motion. Whatever the bytes are, they are poses by increasing time:
/// throws std::invalid_argument unless they are.
void setPoses(const std::string& bytes, cable_variation::Motion& motion);

}  // namespace cable_variation_ros
