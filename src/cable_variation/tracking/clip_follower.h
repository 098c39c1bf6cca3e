#pragma once

#include <cstddef>
#include <optional>

#include <cable_variation/equilibrium/equilibrium.h>

namespace cable_variation {

/// The cables jumped to another equilibrium while their clips moved.
struct ShapeJump {
  double share = 0.0;       ///< of the clips' way, at which it began
  double distance = 0.0;    ///< that the centreline went beyond what its clips' motion explains, at most [m]
  std::size_t cable = 0;    ///< that went furthest
  double arc_length = 0.0;  ///< there [m]
  double energy_before = 0.0, energy_after = 0.0;  ///< total [J]
  double eigenvalue_before = 0.0;                  ///< smallest, before it [N/m]; falls to 0 at a snap
};

/// What became of a shape while its clips moved.
struct FollowedClips {
  Equilibrium equilibrium;        ///< at the end of the way, converged or not
  std::optional<ShapeJump> jump;  ///< the largest on the way
  int solves = 0;                 ///< what it took
};

/// Follows a shape while its clips move, in one leap where that is sure to be smooth, else step by step.
///
/// Where the shape x moves smoothly, x₁ - x₀ is half the sum of its first-order responses to the clips'
/// motion at both ends, but for the third derivative. A step is taken if the difference is no more than a
/// tenth of the motion and 0.2 % of the longest cable, and the motion no more than 5 % of it; other steps are
/// halved, down to 1/128 of the way. What then still differs by more than 1 % of the longest cable, and does
/// not go back the way it came, is a jump: the equilibrium that was followed has ended on the way.
/// @param solver has the equilibrium `before` of `from`; afterwards that at `to`, if there is one
/// @param to differs from `from` in the poses of clips only
/// Throws std::invalid_argument as EquilibriumSolver::update().
FollowedClips followClips(EquilibriumSolver& solver, const Harness& from, const Equilibrium& before,
                          const Harness& to);

}  // namespace cable_variation
