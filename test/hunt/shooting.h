#pragma once

#include <vector>

#include <cable_variation/equilibrium/equilibrium.h>

namespace cable_variation::hunt {

/// The continuum's reactions beside those of an answer.
struct ShotReactions {
  bool solved = false;
  std::vector<Reaction> clips;  ///< one per clip
  double largest_force = 0.0;   ///< along the cable, at least 0.01 EI/L² [N]
  double largest_moment = 0.0;  ///< at least 0.01 EI/L [N m]

  /// The answer's largest error of a force over the largest force, or of a moment over the largest moment.
  double errorOf(const Equilibrium& answer) const;
};

/// The equilibrium next to the answer by multiple shooting: integrateRod() from section to section, and
/// Newton's method, with differences, for the sections and the clips' reactions that make the pieces meet. It
/// shares nothing with the solver but where it begins.
///
/// One cable whose clips, of every kind, do not slide; loads anywhere. Throws std::invalid_argument of
/// others.
ShotReactions shoot(const Harness& harness, const Equilibrium& answer);

}  // namespace cable_variation::hunt
