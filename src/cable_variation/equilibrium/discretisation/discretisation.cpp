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

// Of order two, since a layer that is not yet resolved is what this is for.
double endForceError(double difference, double largest, double least) {
  constexpr double kOrderTwo = 3.0;
  return difference / std::max(largest, least) / kOrderTwo;
}

double negligibleMoment(double bending_stiffness, double length) {
  constexpr double kTurn = 1e-2;  // [rad]
  return kTurn * bending_stiffness / length;
}

namespace {

// Of a cable, after the motion from the fine grid's equilibrium to the coarse one's was solved for.
double forceError(const RodSystem& fine, const RodSystem& coarse, const NodalField& step, std::size_t cable) {
  double force = 0.0, moment = 0.0, largest_force = 0.0, largest_moment = 0.0, softest = INFINITY, tilt = 0.0;
  for (const std::size_t i : fine.topology().cable_spans[cable]) {
    softest = std::min(softest, fine.bendingStiffness(i));
    for (std::size_t k = 0; k <= fine.elementCount(i); ++k) {
      const Vector6d there = fine.sectionForce(i, k);
      largest_force = std::max(largest_force, there.head<3>().norm());
      largest_moment = std::max(largest_moment, there.tail<3>().norm());
    }
    for (int end = 0; end < 2; ++end) {
      const Vector6d difference = coarse.endForceAfter(step, i, end) - fine.endForce(i, end);
      force = std::max(force, difference.head<3>().norm());
      moment = std::max(moment, difference.tail<3>().norm());
    }
    // turns about the own axis are no matter of direction
    tilt = std::max(tilt, step.spans[i].bottomRows<2>().colwise().norm().maxCoeff());
  }
  const double length = fine.harness().cables[cable].length, least = negligibleMoment(softest, length);
  return std::max({endForceError(force, largest_force, least / length),
                   endForceError(moment, largest_moment, least), errorOfFiner(tilt, 1.0) / kDirections});
}

}  // namespace

DiscretisationError estimateDiscretisation(RodSystem& fine, RodSystem& coarse, const Configuration& on_coarse,
                                           bool stable) {
  // Away from its own equilibrium the coarse grid's stiffness against a neutral motion is not zero, but small
  // of either sign: up to this share of the bending stiffness.
  constexpr double kLargestShift = 1e-2;
  DiscretisationError error;
  // A slender rod's own section forces would be those of the little by which the grids' curves differ in
  // length; so would those of a rod between places where it touches.
  const bool slender = fine.slender() || fine.contact() != nullptr;
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
      error.force.assign(fine.harness().cables.size(), error.centreline);
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
  for (std::size_t c = 0; c < fine.harness().cables.size(); ++c)
    error.force.push_back(forceError(fine, coarse, error.step, c));
  return error;
}

}  // namespace cable_variation
