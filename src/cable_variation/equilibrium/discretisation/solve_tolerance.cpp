#include <cable_variation/equilibrium/discretisation/solve_tolerance.h>

#include <algorithm>

namespace cable_variation {

double residualTolerance(const RodSystem& system) {
  double force = 0.0;
  for (const auto& metric : system.bendingMetric()) force = std::max(force, metric.bend);  // EI (π/L)²
  return std::max(20.0 * system.residualNoise(), 1e-10 * force);
}

double neutralShift(const RodSystem& system) { return std::max(kNeutralShift, system.stiffnessNoise()); }

}  // namespace cable_variation
