#pragma once  // internal to equilibrium/

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
};

struct Minimum {
  bool stationary = false;  ///< the residual vanished
  bool stable = false;      ///< and the Hessian there is positive (neutral motions allowed)
  int iterations = 0;       ///< Newton steps
  double residual = 0.0;    ///< [N]
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
