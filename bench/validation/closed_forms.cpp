// Shapes that are known in closed form.

#include <boost/math/special_functions/ellint_1.hpp>
#include <boost/math/special_functions/ellint_2.hpp>

#include <cable_variation/equilibrium/require_converged.h>
#include <cable_variation/math/so3.h>

#include <equilibrium/cases.h>

#include "figures.h"
#include "validation.h"

namespace cable_variation::validation {
namespace {

using Eigen::Vector3d;
using test::cantilever;
using test::clipOn;
using test::loadAt;
using test::roundSection;
using test::uniformCable;

constexpr double kStiff = 1e9;  // EA and GA: stretch and shear are nothing

Equilibrium solved(const Harness& harness) {
  const Equilibrium result = test::solve(harness, 1e-7);
  requireConverged(result, "a closed form");
  return result;
}

// A straight weightless rod of EI = 1 N m² and 1 m, clamped at its start.
Harness rod(const Vector3d& force, const Vector3d& moment, double GJ = 0.8) {
  Harness harness = cantilever(uniformCable(1.0, roundSection(kStiff, kStiff, GJ, 1.0)), Vector3d::Zero());
  harness.clips.push_back(clipOn(0, "tip", 1.0, freeClip()));
  harness.loads = {loadAt(0, 1.0, force, moment)};
  return harness;
}

// Bisshopp and Drucker's tip, by the angle there: the modulus k with k² = (1 + sin θ)/2.
Vector3d elasticaTip(double load) {
  const auto loadOf = [](double angle) {
    const double k = std::sqrt(0.5 * (1.0 + std::sin(angle)));
    const double begin = std::asin(std::sqrt(0.5) / k);
    const double way = boost::math::ellint_1(k) - boost::math::ellint_1(k, begin);
    return way * way;
  };
  double low = 1e-9, high = 0.5 * M_PI - 1e-9;
  for (int i = 0; i < 100; ++i) {
    const double middle = 0.5 * (low + high);
    (loadOf(middle) < load ? low : high) = middle;
  }
  const double k = std::sqrt(0.5 * (1.0 + std::sin(low)));
  const double begin = std::asin(std::sqrt(0.5) / k);
  const double bent = boost::math::ellint_2(k) - boost::math::ellint_2(k, begin);
  return {std::sqrt(2.0 * std::sin(low) / load), 1.0 - 2.0 * bent / std::sqrt(load), 0.0};
}

void addElastica(std::vector<Check>& checks) {
  for (const double load : {1.0, 2.0, 5.0, 10.0}) {
    const Vector3d expected = elasticaTip(load);
    const Vector3d tip =
        solved(rod({0.0, load, 0.0}, Vector3d::Zero())).shapes[0].points.back().pose.position;
    checks.push_back({"elastica: tip of a cantilever of 1 m, P L²/EI = " + numberText(load, 3),
                      pointText(expected, 7) + " m", pointText(tip, 7) + " m",
                      numberText(1e6 * (tip - expected).norm(), 2) + " µm",
                      "elliptic integrals (Bisshopp and Drucker 1945)"});
  }
}

void addRollUp(std::vector<Check>& checks) {
  const Vector3d tip =
      solved(rod(Vector3d::Zero(), {0.0, 0.0, 1.999 * M_PI})).shapes[0].points.back().pose.position;
  const double angle = 1.999 * M_PI;
  const Vector3d expected(std::sin(angle) / angle, (1.0 - std::cos(angle)) / angle, 0.0);
  checks.push_back({"roll-up: tip under M = 1.999 π EI/L", pointText(expected, 6) + " m",
                    pointText(tip, 6) + " m", numberText(1e6 * (tip - expected).norm(), 2) + " µm",
                    "a circle"});
}

// The moment's direction stays in space: the tangent turns about it at the rate |m|/EI.
void addHelix(std::vector<Check>& checks) {
  const double angle = 0.9, amount = 4.0;
  const Vector3d axis(std::cos(angle), std::sin(angle), 0.0);
  const Equilibrium result = solved(rod(Vector3d::Zero(), amount * axis));
  double off = 0.0;
  for (const ShapePoint& point : result.shapes[0].points) {
    const double turned = amount * point.arc_length;
    const Vector3d along = axis.x() * axis, across = Vector3d::UnitX() - along;
    const Vector3d place = point.arc_length * along + std::sin(turned) / amount * across +
                           (1.0 - std::cos(turned)) / amount * axis.cross(across);
    off = std::max(off, (point.pose.position - place).norm());
  }
  checks.push_back({"helix: end moment 4 EI/L at 0.9 rad to the tangent, GJ = 0.8 EI",
                    "radius " + numberText(std::sin(angle) / amount, 6) + " m", "all points within the error",
                    numberText(1e6 * off, 2) + " µm", "a helix, whatever GJ is"});
}

// Greenhill: clamped ends, one free to come nearer; the twist at which the straight shape is no longer
// stable.
void addGreenhill(std::vector<Check>& checks) {
  constexpr double kLambda = 4.493409457909064, kGJ = 4.0;  // tan λ = λ
  const double expected = 2.0 * kLambda / kGJ;
  const auto bends = [&](double twist) {
    Harness harness = test::clamped(uniformCable(1.0, roundSection(1e6, 1e6, kGJ, 1.0)),
                                    {Vector3d(1.0, 0.0, 0.0), so3::exp({twist, 0.0, 0.0})}, Vector3d::Zero());
    harness.clips[1].constraint = guideClip();
    return solved(harness).shapes[0].position(0.5).tail<2>().norm() > 1e-3;
  };
  double low = 0.9 * expected, high = 1.1 * expected;
  while (high - low > 1e-4 * expected) {
    const double middle = 0.5 * (low + high);
    (bends(middle) ? high : low) = middle;
  }
  const double found = 0.5 * (low + high);
  checks.push_back({"loss of stability of a straight rod by twist, clamped, one end free along its axis",
                    numberText(expected, 6) + " rad", numberText(found, 6) + " rad",
                    shareOff(found, expected), "T = 2 λ EI/L, tan λ = λ (Greenhill)"});
}

}  // namespace

Chapter closedForms() {
  Chapter chapter{
      "Closed forms",
      "Weightless rods of EI = 1 N m² and 1 m, stretch and shear next to nothing, solved to 0.1 µm.",
      {},
      ""};
  addElastica(chapter.checks);
  addRollUp(chapter.checks);
  addHelix(chapter.checks);
  addGreenhill(chapter.checks);
  return chapter;
}

}  // namespace cable_variation::validation
