#pragma once

#include <cable_variation/harness/harness.h>
#include <cable_variation/harness/harness_rate.h>

namespace cable_variation {

/// The way of a harness to another one that differs from it in the poses of clips only: origins go straight,
/// axes turn the shortest way.
class ClipWay {
 public:
  /// Throws std::invalid_argument if the harnesses have not the same number of clips.
  ClipWay(Harness from, const Harness& to);

  /// @param share of the way, 0 to 1
  Harness at(double share) const;
  /// Per unit of the share, the same all along.
  const HarnessRate& rate() const { return rate_; }
  /// Whether no clip moves at all.
  bool empty() const { return rate_.clip_frames.empty(); }

 private:
  Harness from_;
  HarnessRate rate_;
};

}  // namespace cable_variation
