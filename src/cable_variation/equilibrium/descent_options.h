#pragma once

#include <vector>

namespace cable_variation {

/// How EquilibriumSolver goes down to a minimum of the energy: Newton's method, kept to steps that its
/// quadratic model may be believed for, its Hessian H damped to H + λM where it is indefinite or the energy
/// will not fall (Levenberg and Marquardt). M is each span's stiffness against its first bending mode, so λ
/// has no unit.
///
/// The defaults are for cables and hoses of any size and slenderness, and are not delicate: half and twice of
/// each solve the same random harnesses in 0.93 to 1.16 times the steps (`hunt --descent`, doc/hunt.md, which
/// is how to find others). They change which of several stable shapes a start leads to, never what counts as
/// an equilibrium.
struct DescentOptions {
  /// No section turns further in a step [rad]; above 0, at most 1. Beyond, the energy of a bending step is no
  /// longer near its quadratic model.
  double largest_rotation = 0.35;
  /// No section moves further in a step, as a share of the longest cable; above 0, at most 1. What swings or
  /// slides as a whole needs this bound, as it turns no section far.
  double largest_displacement = 0.1;
  /// λ where damping begins; above 0, at most 1e6. At 1 the softest modes are damped as much as they resist.
  double first_damping = 0.1;
  /// By this λ grows, and shrinks after steps that were as good as predicted; above 1, at most 1000.
  double damping_growth = 8.0;
  /// Below it λ is none; above 0, at most 1. Newton's method then is its quadratic self.
  double smallest_damping = 1e-3;
  /// So many steps in a row may be without a new lowest energy; 0 to 1000. A stiff cable is stretched by
  /// turning and shrinks back in the next steps: without any climbs case W took 26 steps on its start grid
  /// instead of 18.
  int longest_climb = 8;
  /// After a step that is no longer than this (in radians, and as a share of the longest cable) the same
  /// factors serve for the next ones; 0 (never) to 0.1.
  double reuse_below = 1e-2;
  /// For as long as each is shorter than this share of the one before; above 0, below 1.
  double contraction = 0.1;
};

/// Throws std::invalid_argument that names the field, its value and the range, of the first that is out of
/// it.
void validate(const DescentOptions& options);

/// One of the numbers above, for what tries or checks them all.
struct DescentNumber {
  const char* name;
  double lower, upper;  ///< within which it may be
  bool lower_allowed;   ///< the lower bound itself, too
  bool upper_allowed;
  double (*get)(const DescentOptions&);
  void (*set)(DescentOptions&, double);
};
const std::vector<DescentNumber>& descentNumbers();

}  // namespace cable_variation
