#pragma once  // internal to equilibrium/

#include <cable_variation/equilibrium/descent_options.h>
#include <cable_variation/equilibrium/discretisation/solve_tolerance.h>

namespace cable_variation {

/// What the geometric stiffness of the first step is made of.
enum class StartStress {
  own,   ///< the section forces of the start's strains
  none,  ///< nothing: the start's strains mean nothing
  held   ///< what the system holds: predicted, or taken from another grid
};

struct MinimiseOptions {
  int max_iterations = 400;
  bool settle = false;  ///< only Newton steps to the stationary point near by, stable or not
  StartStress stress = StartStress::own;
  /// Ends near a minimum, where the Hessian is positive and what is left is so little that the energy is
  /// known to 1e-8: enough to tell minima apart. The residual is not judged.
  bool rough = false;
  DescentOptions descent;
};

/// Why a descent ended.
enum class DescentEnd {
  minimum,          ///< the residual vanished, and the Hessian is positive (neutral motions allowed)
  near_minimum,     ///< MinimiseOptions::rough: as near as was asked for
  saddle,           ///< the residual vanished, the Hessian is not positive, and no way down was found
  residual_left,    ///< steps became next to nothing, the residual did not
  indefinite,       ///< no damping makes the Hessian positive
  no_descent,       ///< no damping makes the energy fall
  not_finite,       ///< a step is not a number
  far_away,         ///< MinimiseOptions::settle: a step leads away from the shape that was near
  most_iterations,  ///< MinimiseOptions::max_iterations
};

const char* toString(DescentEnd end);

struct Minimum {
  DescentEnd end = DescentEnd::most_iterations;
  int iterations = 0;     ///< Newton steps
  double residual = 0.0;  ///< [N]

  bool stable() const { return end == DescentEnd::minimum || end == DescentEnd::near_minimum; }
  bool stationary() const { return stable() || end == DescentEnd::saddle; }
};

/// From `configuration` to a minimum of the energy: Newton steps, shifted
/// towards steepest descent in the metric of the first bending modes while the
/// Hessian is indefinite or the energy will not fall (Levenberg and Marquardt),
/// and pushed off a saddle along its direction of negative curvature. The
/// geometric stiffness comes from predicted stresses, and the energy may rise for
/// a few steps: a stiff cable is stretched by turning and shrinks back in the
/// next. What is called stable was judged by the exact Hessian at the configuration
/// returned. Deterministic. On return `system` holds the gradient there, and unless it
/// settled or failed, the factorised Hessian.
Minimum minimise(RodSystem& system, Configuration& configuration, const MinimiseOptions& options = {});

}  // namespace cable_variation
