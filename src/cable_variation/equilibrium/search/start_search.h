#pragma once  // internal to equilibrium/

#include <string>
#include <vector>

#include <cable_variation/equilibrium/discretisation/problem.h>
#include <cable_variation/equilibrium/equilibrium.h>

namespace cable_variation {

/// The slenderness EA ℓ²/EI that spans are softened to (RodSystem::soften()) while starts are tried: beyond
/// it steps towards a minimum become short, while its shape hardly changes.
constexpr double kSearchSlenderness = 3e3;

/// A stationary shape that a start led to.
struct FoundShape {
  Configuration configuration;
  double energy = 0.0;  ///< on the start grid, stretch softened [J]
  /// Why it is not what was asked for, whatever its energy: whole turns that hinted cables have more or less,
  /// and loads that it has carried to another place altogether.
  int departures = 0;
};

struct SearchResult {
  std::vector<FoundShape> minima;   ///< by energy
  std::vector<FoundShape> saddles;  ///< one at most, and only when there is no minimum
  std::string failure;              ///< where the first start that led nowhere failed
};

/// Multi-start on the problem's grid, with its stretch softened: the natural routing; then every other
/// bulge and a turn more or less, for every second interval at once, so that the
/// effort stays linear in the size of the harness; then the best of each
/// interval together. Intervals with hints keep their hinted start. A turn that the way down has put into the
/// lowest one, or lost from a twist that was asked for, is taken out again. Iterations are added to `result`.
SearchResult searchStarts(Problem& problem, const EquilibriumOptions& options, Equilibrium& result);

}  // namespace cable_variation
