// Problems of the literature, and solutions of the continuum.

#include <algorithm>
#include <cmath>

#include <cable_variation/equilibrium/require_converged.h>
#include <cable_variation/math/so3.h>

#include <equilibrium/cases.h>

#include "../reference_case.h"
#include "figures.h"
#include "followed.h"
#include "validation.h"

namespace cable_variation::validation {
namespace {

using Eigen::Vector3d;
using test::cantilever;
using test::clipOn;
using test::loadAt;
using test::poseAt;
using test::uniformCable;

Vector3d tipOf(const Harness& harness, double accuracy) {
  const Equilibrium result = test::solve(harness, accuracy);
  requireConverged(result, "a benchmark");
  return result.shapes[0].points.back().pose.position;
}

// An eighth of a circle of radius 100, unit square section, loaded out of its plane.
void addBend(std::vector<Check>& checks) {
  struct Row {
    double torsion, force;
    Vector3d tip;
    const char* source;
  };
  const char* table = "converged, by collocation and shooting";
  const char* published = "Simo and Vu-Quoc 1986, eight linear elements";
  for (const Row& row : {Row{1.0 / 6.0, 300.0, {22.2448, 58.7791, 40.1919}, table},
                         Row{1.0 / 6.0, 600.0, {15.6848, 47.1504, 53.4749}, table},
                         Row{0.1406, 300.0, {22.1128, 58.5362, 40.4800}, table},
                         Row{0.1406, 600.0, {15.5579, 46.8922, 53.6072}, table},
                         Row{1.0 / 6.0, 300.0, {22.33, 58.84, 40.08}, published},
                         Row{1.0 / 6.0, 600.0, {15.79, 47.23, 53.37}, published}}) {
    const double E = 1e7, G = 5e6, radius = 100.0;
    const Section section{E, G, G, G * row.torsion, E / 12.0, E / 12.0, 0.0, std::sqrt(0.5)};
    Cable cable = uniformCable(radius * M_PI / 4.0, section);
    cable.rest_curvature = {{0.0, {0.0, 0.0, -1.0 / radius}}};
    Harness harness = cantilever(cable, Vector3d::Zero());
    harness.clips[0].pose.orientation = so3::exp({0.0, 0.0, M_PI / 2.0});
    harness.clips.push_back(clipOn(0, "tip", cable.length, freeClip()));
    harness.loads = {loadAt(0, cable.length, {0.0, 0.0, row.force})};
    const Vector3d tip = tipOf(harness, 1e-6);
    checks.push_back({"45° bend (Bathe and Bolourchi 1979), P = " + numberText(row.force, 3) +
                          ", J = " + numberText(row.torsion, 4),
                      pointText(row.tip, 6), pointText(tip, 6),
                      numberText((tip - row.tip).cwiseAbs().maxCoeff(), 2) + " of 100", row.source});
  }
}

// The beam of Dowell and Traybar, 8.896 N at its tip.
void addPrinceton(std::vector<Check>& checks) {
  struct Row {
    double beta, wide, thin;
  };
  for (const Row& row :
       {Row{0, 10.713, 0.0}, Row{30, 10.208, 79.547}, Row{60, 6.742, 129.958}, Row{90, 0.0, 146.252}}) {
    const double length = 0.508, wide = 12.3777e-3, thin = 3.2024e-3, E = 71.7e9, G = E / (2.0 * 1.31);
    const double about_thin = thin * std::pow(wide, 3) / 12.0, about_wide = wide * std::pow(thin, 3) / 12.0;
    const Section section{E * wide * thin,
                          G * wide * thin,
                          G * wide * thin,
                          G * 0.198 * (about_thin + about_wide),
                          E * about_wide,
                          E * about_thin,
                          0.0,
                          0.5 * wide};
    const double beta = row.beta * M_PI / 180.0;
    Harness harness = cantilever(uniformCable(length, section), Vector3d::Zero());
    harness.clips.push_back(clipOn(0, "tip", length, freeClip()));
    harness.loads = {loadAt(0, length, 8.896 * Vector3d(0.0, std::cos(beta), std::sin(beta)))};
    const Vector3d tip = 1e3 * tipOf(harness, 1e-7);
    const double off = std::hypot(tip.y() - row.wide, tip.z() - row.thin);
    checks.push_back({"Princeton beam, 8.896 N at " + numberText(row.beta, 3) + "° to its wide direction",
                      numberText(row.wide, 6) + ", " + numberText(row.thin, 6) + " mm",
                      numberText(tip.y(), 6) + ", " + numberText(tip.z(), 6) + " mm",
                      numberText(1e3 * off, 2) + " µm", "converged solution of the same rod"});
  }
}

// DaDeppo and Schmidt: 215° of a circle, clamped at one end, hinged at the other, a load on its crown. Stiff
// out of its plane, in which they calculate.
void addDeepArch(std::vector<Check>& checks) {
  const double radius = 100.0, angle = 215.0 * M_PI / 180.0, EI = 1e6, stiff = 1e10;
  const double length = radius * angle;
  const auto at = [&](double load) {
    // bends about y in the plane x-z; z is up
    Cable cable = uniformCable(length, Section{1e8, 1e8, 1e8, stiff, EI, stiff, 0.0, 0.5});
    cable.rest_curvature = {{0.0, {0.0, 1.0 / radius, 0.0}}};
    Harness harness = cantilever(cable, Vector3d::Zero());
    // the first tangent is turned by half the angle from the crown's, upwards
    harness.clips[0].pose.orientation = so3::exp({0.0, -0.5 * angle, 0.0});
    Pose end;
    end.orientation = so3::exp({0.0, 0.5 * angle, 0.0});
    end.position = {2.0 * radius * std::sin(0.5 * angle), 0.0, 0.0};
    harness.clips.push_back(clipOn(0, "hinge", length, hingeClip(Axis::y), end));
    harness.loads = {loadAt(0, 0.5 * length, {0.0, 0.0, -load})};
    return harness;
  };
  const double expected = 897.0;
  const double found = followedTo(at, 10.0, 20.0, 2000.0, 15.0);
  checks.push_back({"deep arch: buckling load, EI/R² = 100", numberText(expected, 4), numberText(found, 5),
                    shareOff(found, expected), "DaDeppo and Schmidt 1975, inextensible: 8.97 EI/R²"});
}

// A shallow arch between clamps, one of which turns until it snaps. To first order the turn over the square
// root of the end's shortening is a number: the largest μ for which w'''' + τ² w'' = 0 has w'(0) = μ, w = w'
// = 0 at the other end, w(0) = 0 and ∫w'² = 2.
double foldOfShallowArch() {
  const auto turnAt = [](double tau) {
    // w = a sin τx + b (cos τx - 1) + c x for w'(0) = 1
    const double sine = std::sin(tau), cosine = std::cos(tau);
    Eigen::Matrix3d conditions;
    conditions << tau, 0.0, 1.0, tau * cosine, -tau * sine, 1.0, sine, cosine - 1.0, 1.0;
    const Vector3d w = conditions.fullPivLu().solve(Vector3d(1.0, 0.0, 0.0));
    double sum = 0.0;
    constexpr int kSteps = 2000;
    for (int i = 0; i < kSteps; ++i) {
      const double x = (i + 0.5) / kSteps;
      const double slope = tau * (w[0] * std::cos(tau * x) - w[1] * std::sin(tau * x)) + w[2];
      sum += slope * slope / kSteps;
    }
    return std::sqrt(2.0 / sum);
  };
  double largest = 0.0;
  for (double tau = 2.0 * M_PI + 1e-3; tau < 2.0 * 4.4934; tau += 1e-4)
    largest = std::max(largest, turnAt(tau));
  return largest;
}

void addArchSnap(std::vector<Check>& checks) {
  const double expected = foldOfShallowArch();
  for (const double shortening : {0.01, 0.0025}) {
    const auto at = [&](double turn) {
      Cable cable = uniformCable(1.0, Section{1e9, 1e9, 1e9, 1e3, 1.0, 1e3, 0.0, 1e-3});
      cable.via = {{0.25, 0.0, std::sqrt(shortening) / M_PI},
                   {0.5, 0.0, 2.0 * std::sqrt(shortening) / M_PI},
                   {0.75, 0.0, std::sqrt(shortening) / M_PI}};
      Harness harness = test::clamped(cable, poseAt(1.0 - shortening, 0.0, 0.0), Vector3d::Zero());
      // downwards, away from the arch
      harness.clips[0].pose.orientation = so3::exp({0.0, turn, 0.0});
      return harness;
    };
    const double jump = 0.3 * std::sqrt(shortening);
    const double found =
        followedTo(at, 1e-3, 0.02 * std::sqrt(shortening), 1.5, jump) / std::sqrt(shortening);
    checks.push_back({"arch with an end that turns, shortened by " + numberText(100.0 * shortening, 3) +
                          " %: turn over √shortening at which it snaps",
                      numberText(expected, 5), numberText(found, 5), shareOff(found, expected),
                      "shallow arch to first order in the shortening (as Gomez, Moulton and Vella 2017)"});
  }
}

}  // namespace

Chapter referenceSolutions() {
  Chapter chapter{
      "Solutions of the continuum",
      "A hose and a strand between clamps (`test/data/reference`), solved as a boundary value problem by "
      "collocation and by shooting, to 1e-9 m. Asked for: 1 µm.",
      {},
      ""};
  for (const char name : {'H', 'W'}) {
    const bench::ReferenceCase reference = bench::referenceCase(name);
    const Equilibrium result = test::solve(reference.harness, 1e-6);
    requireConverged(result, "a reference case");
    const double off = bench::deviation(reference, result.shapes[0]);
    chapter.checks.push_back({std::string("case ") + name + ": the whole centreline", "", "",
                              numberText(1e6 * off, 2) + " µm", "collocation and shooting"});
  }
  return chapter;
}

Chapter publishedBenchmarks() {
  Chapter chapter{
      "Published benchmarks",
      "Lengths of the bend and of the arch are in their own units. What the literature calculated with few "
      "elements, or without stretch, differs by that.",
      {},
      ""};
  addBend(chapter.checks);
  addPrinceton(chapter.checks);
  addDeepArch(chapter.checks);
  addArchSnap(chapter.checks);
  return chapter;
}

}  // namespace cable_variation::validation
