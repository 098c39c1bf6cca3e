#pragma once

#include <cstddef>
#include <limits>
#include <string>
#include <vector>

#include <cable_variation/tolerances/sample_space.h>

namespace cable_variation {

/// A stretch of time within which nothing that holds the cables goes far, or all of it goes straight.
struct MotionPhase {
  std::vector<double> times;  ///< to look at, increasing; the last is the next phase's first [s]
  double reference = 0.0;     ///< one of them, in the middle [s]
  /// What a convex body over all poses spans beyond them, about: how far the middle between two of some poses
  /// of the phase is off the way, for the clip that is furthest off, its turning counted with the lever [m].
  double excess = 0.0;
};

/// How long phases may get. A clip's turning counts with `lever`.
struct PhaseRule {
  double stride = 0.0;  ///< as far as this a clip may go any way [m]
  double reach = 0.0;   ///< and as far as this if no clip goes off the straight way by more than `bow` [m];
                        ///< no more than `stride`: none may
  double bow = 0.0;     ///< [m]
  double lever = 0.0;   ///< [m]
  /// Phases wanted at most; for more of them all three lengths grow until they are no more.
  std::size_t most = std::numeric_limits<std::size_t>::max();
};

/// Cuts the motions between `from` and `to` [s] into phases, by how the clips go as seen from any of the
/// frames ("world" or components). Times are those of the recordings, and more of them between two where the
/// clips go further than half a stride. Where poses have the same stamp the motion steps: a time just before
/// it is looked at, too. Without motions: one phase of the time `from`.
/// @param wanted if given, set to the number of phases by the rule's lengths as they are
std::vector<MotionPhase> cutIntoPhases(const SampleSpace& space, const std::vector<std::string>& frames,
                                       double from, double to, const PhaseRule& rule,
                                       std::size_t* wanted = nullptr);

}  // namespace cable_variation
