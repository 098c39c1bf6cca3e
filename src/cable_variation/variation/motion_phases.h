#pragma once

#include <string>
#include <vector>

#include <cable_variation/variation/sample_space.h>

namespace cable_variation {

/// A stretch of time within which nothing that holds the cables goes far.
struct MotionPhase {
  std::vector<double> times;  ///< to look at, increasing; the last is the next phase's first [s]
  double reference = 0.0;     ///< one of them, in the middle [s]
};

/// Cuts the motions between `from` and `to` [s] into phases: one lasts until a clip has gone further than
/// `stride` [m] from where it was at the phase's start, seen from any of the frames ("world" or components),
/// its turning counted with `lever` [m]. Times are those of the recordings, and more of them between two
/// where the clips go further than half a stride. Without motions: one phase of the time `from`.
std::vector<MotionPhase> cutIntoPhases(const SampleSpace& space, const std::vector<std::string>& frames,
                                       double from, double to, double stride, double lever);

}  // namespace cable_variation
