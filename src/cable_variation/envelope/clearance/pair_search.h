#pragma once  // internal to envelope/

#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include <cable_variation/envelope/clearance/clearance_samples.h>
#include <cable_variation/tolerances/tolerance_space.h>

namespace cable_variation {

/// How close two cables come in one and the same harness, at one time.
struct ClosestTogether {
  SampleDistance closest;  ///< of all that were solved
  std::size_t shapes = 0;  ///< independent random ones, drawn when the search had ended
  double closer = 0.0;     ///< by how much one of these comes closer than what the search had found [m]
};

struct PairSearchOptions {
  double tolerance = 4e-5;    ///< gains that are not worth a step [m]
  std::size_t shapes = 2000;  ///< random ones to look at, again and again until none comes closer
  std::uint64_t seed = 1;
  std::function<void()> check;  ///< called now and then, by any thread; may throw
};

/// Looks for the smallest distance over all deviations and times: down the slopes, from the design, from the
/// closest samples of the envelope, and from random shapes that come closer than what was found.
/// @param phase_bounds per phase of the envelope: no harness in it is closer [m]; infinity: nothing to
/// measure None if nothing is to be measured.
std::optional<ClosestTogether> closestTogether(SampleShapes& shapes, const ExactDistance& distance,
                                               const ToleranceSpace& tolerances,
                                               const std::vector<double>& phase_bounds,
                                               const PairSearchOptions& options);

}  // namespace cable_variation
