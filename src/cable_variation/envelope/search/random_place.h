#pragma once  // internal to envelope/

#include <cstdint>
#include <vector>

#include <cable_variation/tolerances/sample_space.h>

namespace cable_variation {

/// Draws place number `index` of a sequence: a time evenly over the motion, and deviations evenly within the
/// tolerances (even numbers) or spread over their limits (odd).
SamplePlace drawPlace(const SampleSpace& space, double from, double to, const CounterRandom& random,
                      std::uint64_t index);

/// Whether drawPlace() draws that number evenly.
inline bool isDrawnEvenly(std::uint64_t index) { return index % 2 == 0; }

/// Random places that an envelope learns from, round by round: always others. Where shapes are rare, and
/// evenly drawn ones hardly ever come, others like them (ToleranceSpace::offspring()) are among them.
struct LearningPlaces {
  const SampleSpace& space;
  double from = 0.0, to = 0.0;  ///< [s]
  std::uint64_t seed = 1;
  std::size_t count = 0;          ///< drawn all over
  std::vector<SamplePlace> rare;  ///< to look for more like these

  /// @param like_rare so many of these; the same order of magnitude in all rounds
  std::vector<SamplePlace> ofRound(int round, std::size_t like_rare) const;
};

}  // namespace cable_variation
