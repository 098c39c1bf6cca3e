#pragma once

#include <hunt/discrete_rod.h>

namespace cable_variation::hunt {

struct Settling {
  bool stationary = false;
  bool stable = false;  ///< the Hessian there, of its own stresses, is positive definite
  int iterations = 0;
};

/// Newton's method without any safeguard but a bound on the step: to the stationary shape near by, be it a
/// minimum or not. `force` of the shape should be near that of the answer.
Settling settle(const DiscreteRod& rod, DiscreteShape& shape);

/// Downhill to a stable shape, wherever the shape starts: first with lowered EA, which is then raised.
Settling descend(const DiscreteRod& rod, DiscreteShape& shape);

/// Of the exact Hessian at the shape, in the surface's root-mean-square motion [N/m], by bisection over
/// shifts with the inertia of the shifted Hessian (Sylvester).
double smallestEigenvalue(const DiscreteRod& rod, const DiscreteShape& shape, double relative = 1e-2);

}  // namespace cable_variation::hunt
