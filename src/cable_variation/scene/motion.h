#pragma once

#include <string>
#include <vector>

#include <cable_variation/math/pose.h>

namespace cable_variation {

/// A component's pose in its parent's frame at one time.
struct TimedPose {
  double time = 0.0;  ///< [s], from the motion's own start
  Pose pose;
};

/// A recorded motion of one component, replacing its pose in its parent.
struct Motion {
  std::string name;
  std::string component;
  std::string file;   ///< address of a TUM trajectory or a bag
  std::string path;   ///< the local file it stands for
  std::string topic;  ///< of a bag: a pose topic, or /tf
  std::string frame;  ///< of a bag, on /tf: the child frame to look for; the component's name if not given
  std::vector<TimedPose> samples;  ///< by increasing time; empty until loaded (bags are read by the ROS side)
  std::size_t replaced_poses = 0;  ///< of the file, by another pose at the same time
  int line = 0;                    ///< of the scene file

  double duration() const { return samples.empty() ? 0.0 : samples.back().time; }
};

/// Pose at `time` [s], clamped to the recording: linear in position, slerp in
/// orientation. Throws std::invalid_argument if nothing is loaded.
Pose poseAt(const Motion& motion, double time);

/// Whether a motion's file is a bag, by its name.
bool isBag(const std::string& file);

/// Reads a TUM trajectory into a motion's samples: lines `time tx ty tz qx qy qz qw`, # starts a comment.
/// Times are shifted to start at 0; of poses at the same time the last one counts.
/// Throws std::invalid_argument with file and line: numbers missing, not finite,
/// with commas, a time before that of the line before, zero quaternion, a norm further than
/// 1e-3 from 1; and for what is no file, or has more than a gigabyte.
void readTum(const std::string& path, Motion& motion);

}  // namespace cable_variation
