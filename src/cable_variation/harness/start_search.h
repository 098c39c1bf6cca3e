#pragma once

#include <string>

#include <cable_variation/harness/equilibrium.h>
#include <cable_variation/harness/problem.h>

namespace cable_variation {

struct SearchResult {
  bool found = false;   ///< the problem's configuration is stationary
  bool stable = false;  ///< and a minimum
  std::string failure;  ///< where the first start that led nowhere failed
};

/// Multi-start on the problem's grid: the natural routing; then every other
/// bulge and a turn more or less, for every second interval at once, so that the
/// effort stays linear in the size of the harness; then the best of each
/// interval together. Of the minima found the one of lowest energy becomes the
/// problem's configuration, the others become alternatives of `result`. Intervals
/// with hints keep their hinted start. Iterations are added to `result`.
SearchResult searchStarts(Problem& problem, const EquilibriumOptions& options, Equilibrium& result);

}  // namespace cable_variation
