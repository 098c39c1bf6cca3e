#include <cable_variation/equilibrium/discretisation/discretisation.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include <cable_variation/equilibrium/discretisation/solve_tolerance.h>

namespace cable_variation {

double errorOfFiner(double difference, double length) {
  constexpr double kOrderTwo = 3.0;
  constexpr double kOrderThree = 7.0;
  constexpr double kAsymptotic = 2e-4;  // of the length: above it the order cannot be counted on
  return difference / (difference > kAsymptotic * length ? kOrderTwo : kOrderThree);
}

DiscretisationError estimateDiscretisation(RodSystem& fine, RodSystem& coarse, const Configuration& on_coarse,
                                           bool stable) {
  // Away from its own equilibrium the coarse grid's stiffness against a neutral motion is not zero, but small
  // of either sign: up to this share of the bending stiffness.
  constexpr double kLargestShift = 1e-2;
  DiscretisationError error;
  // A slender rod's own section forces would be those of the little by which the grids' curves differ in
  // length.
  const bool slender = fine.slender();
  const RodSystem::Hessian hessian = slender ? RodSystem::Hessian::predicted : RodSystem::Hessian::exact;
  if (slender) {
    fine.holdStress();
    coarse.takeStress(fine);
  }
  coarse.evaluate(on_coarse, hessian);
  for (std::size_t i = 0; i < coarse.grid().size(); ++i) {
    error.contribution.emplace_back();
    for (std::size_t k = 0; k < coarse.elementCount(i); ++k) {
      const double halves = fine.elementEnergy(i, 2 * k) + fine.elementEnergy(i, 2 * k + 1);
      error.contribution.back().push_back(std::abs(coarse.elementEnergy(i, k) - halves));
    }
  }
  double shift = neutralShift(coarse);
  while (coarse.factorise(shift, coarse.bendingMetric()) > 0 && stable) {
    shift *= 100.0;
    if (shift > kLargestShift) {
      error.centreline = std::numeric_limits<double>::infinity();
      return error;
    }
    coarse.evaluate(on_coarse, hessian);
  }
  NodalField force = coarse.gradient();
  force.scale(-1.0);
  coarse.solve(force, error.step);
  double difference = 0.0;
  for (const auto& nodes : error.step.spans) {
    difference = std::max(difference, nodes.topRows<3>().colwise().norm().maxCoeff());
  }
  error.centreline = errorOfFiner(difference, largestArcLength(on_coarse));
  return error;
}

}  // namespace cable_variation
