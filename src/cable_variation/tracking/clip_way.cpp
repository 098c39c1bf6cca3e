#include <cable_variation/tracking/clip_way.h>

#include <stdexcept>
#include <string>
#include <utility>

#include <cable_variation/math/so3.h>

namespace cable_variation {

ClipWay::ClipWay(Harness from, const Harness& to) : from_(std::move(from)) {
  if (from_.clips.size() != to.clips.size()) {
    throw std::invalid_argument("the way of " + std::to_string(from_.clips.size()) + " clips to " +
                                std::to_string(to.clips.size()) + "; expected as many");
  }
  for (std::size_t i = 0; i < to.clips.size(); ++i) {
    const Pose &start = from_.clips[i].pose, &end = to.clips[i].pose;
    FrameRate rate;
    rate.translation = end.position - start.position;
    rate.rotation = so3::log(end.orientation * start.orientation.conjugate());
    if (!rate.translation.isZero(0.0) || !rate.rotation.isZero(0.0)) rate_.clip_frames.emplace_back(i, rate);
  }
}

Harness ClipWay::at(double share) const {
  Harness harness = from_;
  for (const auto& [index, rate] : rate_.clip_frames) {
    Pose& pose = harness.clips[index].pose;
    pose.position += share * rate.translation;
    pose.orientation = (so3::exp(share * rate.rotation) * pose.orientation).normalized();
  }
  return harness;
}

}  // namespace cable_variation
