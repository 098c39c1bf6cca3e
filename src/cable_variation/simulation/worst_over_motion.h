#pragma once  // internal to simulation/

#include <functional>
#include <vector>

#include <cable_variation/measures/measure_evaluation.h>
#include <cable_variation/tolerances/sample_space.h>
#include <cable_variation/tolerances/sampler.h>

namespace cable_variation {

/// The times of a motion that decide what the worst over it is.
struct WorstTimes {
  std::vector<double> times;  ///< increasing [s]
  /// Per measure: how much worse one of the trial samples is predicted to get at another time, at most [its
  /// unit].
  std::vector<double> missed;
  std::size_t phases = 0;  ///< that the first-order model was made in
  /// Per measure: in so many phases the design's value is infinite, or has no derivatives that are numbers:
  /// the model does not know how bad samples get there.
  std::vector<std::size_t> unknown;
};

/// Looks at every pose recorded between `from` and `to` [s] with the first-order model of its phase
/// (cutIntoPhases), for a few hundred trial samples, and keeps the times that are worst for some sample and
/// some measure: those that matter most first, until none is missed by more than a hundredth of the measure's
/// spread, or there are `most`. A measure without a value, or with one that is as good as can be at all times
/// (the bend radius of a straight cable), has no say; without any that has one, times are spread evenly.
/// @param trials draws deviations; all of them are looked at
/// @param solver the design's shape to follow
/// @param goes_on asked at every pose; false: leave it, no times
/// Throws as requireConverged(), naming the time: the design has no equilibrium.
WorstTimes findWorstTimes(const SampleSpace& space, const std::vector<std::size_t>& measures,
                          const MeasureEvaluator& evaluator, const Sampler& trials, double from, double to,
                          std::size_t most, EquilibriumSolver solver, const std::function<bool()>& goes_on);

}  // namespace cable_variation
