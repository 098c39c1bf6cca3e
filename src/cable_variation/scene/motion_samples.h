#pragma once

#include <string>
#include <vector>

#include <cable_variation/scene/motion.h>

namespace cable_variation {

/// Gathers the poses of a recording, from whatever file, by one rule: time never goes
/// back; of poses at the same time the last one counts.
class MotionSamples {
 public:
  /// @param time [s], from any origin. Throws std::invalid_argument if it is before that of the pose before,
  /// or not finite.
  void add(double time, const Pose& pose);

  std::size_t size() const { return samples_.size(); }

  /// Sets samples (their times from 0) and replaced poses of a motion. Throws std::invalid_argument if there
  /// are no poses.
  void finish(Motion& motion) const;

 private:
  std::vector<TimedPose> samples_;
  std::size_t replaced_ = 0;
};

/// "3 of its poses have the same time as the next, at another place; ...": "" if none was replaced.
std::string noteOnReplaced(const Motion& motion);

}  // namespace cable_variation
