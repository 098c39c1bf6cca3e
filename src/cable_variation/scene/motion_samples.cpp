#include <cable_variation/scene/motion_samples.h>

#include <cmath>
#include <iomanip>
#include <locale>
#include <sstream>
#include <stdexcept>

namespace cable_variation {
namespace {

bool same(const Pose& a, const Pose& b) {
  const auto& p = a.orientation.coeffs();
  const auto& q = b.orientation.coeffs();
  return a.position == b.position && (p == q || p == -q);
}

std::string seconds(double time) {
  std::ostringstream text;
  text.imbue(std::locale::classic());
  text << std::fixed << std::setprecision(6) << time << " s";
  return text.str();
}

}  // namespace

void MotionSamples::add(double time, const Pose& pose) {
  if (!std::isfinite(time)) throw std::invalid_argument("its time is not finite");
  if (!samples_.empty() && time <= samples_.back().time) {
    TimedPose& last = samples_.back();
    if (time < last.time) {
      throw std::invalid_argument("time " + seconds(time) + " is before " + seconds(last.time) +
                                  " of the pose before");
    }
    if (same(last.pose, pose)) return;
    last.pose = pose;
    ++replaced_;
    return;
  }
  samples_.push_back({time, pose});
}

void MotionSamples::finish(Motion& motion) const {
  if (samples_.empty()) throw std::invalid_argument("it holds no pose");
  motion.samples = samples_;
  motion.replaced_poses = replaced_;
  for (TimedPose& sample : motion.samples) sample.time -= samples_.front().time;
}

std::string noteOnReplaced(const Motion& motion) {
  const std::size_t count = motion.replaced_poses;
  if (count == 0) return "";
  return std::to_string(count) + (count == 1 ? " of its poses has" : " of its poses have") +
         " the same time as the next one, and another place; of " + std::to_string(motion.samples.size()) +
         " times the last pose counts";
}

}  // namespace cable_variation
