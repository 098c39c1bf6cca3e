// The shipped scenes in which cables touch: the harness on a stay's tab, the bundle over a rail.

#include <algorithm>
#include <cmath>
#include <string>

#include <gtest/gtest.h>

#include <cable_variation/equilibrium/equilibrium.h>
#include <cable_variation/measures/measure_evaluation.h>
#include <cable_variation/scene/design.h>
#include <cable_variation/scene_file/scene_reader.h>
#include <cable_variation/sensitivity/stability_analysis.h>

#include "test_packages.h"

namespace cable_variation {
namespace {

using Eigen::Vector3d;

constexpr double kAccuracy = 1e-4;  // of the scenes [m]

Scene shipped(const std::string& name) {
  return readScene(std::string(CABLE_VARIATION_SOURCE_DIR) + "/config/" + name + ".yaml", findTestPackage);
}

Equilibrium solved(const Harness& harness) {
  EquilibriumOptions options;
  options.accuracy = kAccuracy;
  EquilibriumSolver solver(options);
  return solver.solve(harness);
}

TEST(ShippedContact, HarnessLiesOnTheTabThatItGoesThroughWithoutContact) {
  const DesignValues turned = {{"wh_start_ry", 5.0 * M_PI / 180.0}, {"wh_start_rz", 5.0 * M_PI / 180.0}};
  const Scene with = shipped("harness_contact"), without = shipped("harness");
  const Equilibrium lying = solved(harnessAt(with, turned));
  const Equilibrium through = solved(harnessAt(without, turned));
  ASSERT_TRUE(lying.converged()) << lying.message;
  ASSERT_TRUE(through.converged()) << through.message;
  ASSERT_EQ(lying.contacts.size(), 1U);
  const ContactInterval& tab = lying.contacts[0];
  EXPECT_EQ(tab.part, "engine_bay");
  EXPECT_GT(tab.force.z(), 0.0) << "it is carried";
  EXPECT_GE(lying.smallest_gap, -1e-5);
  // what it is lifted by is what it went in by; the force is what the free shape resists that with
  const double s = 0.5 * (tab.start + tab.end);
  const Vector3d lifted = lying.shapes[0].position(s) - through.shapes[0].position(s);
  EXPECT_NEAR(lifted.dot(tab.force.normalized()), 0.58e-3, 0.1e-3);
  // a constraint more never costs less
  EXPECT_GT(lying.energy.total(), through.energy.total());
  EXPECT_NEAR(lying.energy.total() - through.energy.total(), 0.5 * tab.total * 0.58e-3,
              0.3 * tab.total * 0.58e-3);
}

TEST(ShippedContact, HarnessThatTouchesNothingIsTheSame) {
  const Scene with = shipped("harness_contact"), without = shipped("harness");
  const Equilibrium a = solved(with.harness), b = solved(without.harness);
  ASSERT_TRUE(a.converged()) << a.message;
  EXPECT_TRUE(a.contacts.empty());
  for (const double s : {0.05, 0.15, 0.25}) {
    EXPECT_LT((a.shapes[0].position(s) - b.shapes[0].position(s)).norm(), 2.0 * kAccuracy) << s;
  }
}

// Along the crown the bundle bears on it with what its tension T presses by, T over the radius of the
// centreline, and its weight. It lies on some of the crown's facets' edges, so that of a part of the stretch
// this is known to what two of them bear.
TEST(ShippedContact, BundleLiesAlongTheRail) {
  constexpr double kCrown = 0.6, kRadius = 0.008, kWeight = 0.45 * 9.81;
  const Scene scene = shipped("rail");
  const Equilibrium result = solved(scene.harness);
  ASSERT_TRUE(result.converged()) << result.message;
  ASSERT_EQ(result.contacts.size(), 3U) << "two clips and the rail between them";
  EXPECT_GE(result.smallest_gap, -1e-5);
  const ContactInterval& rail = result.contacts[1];
  const double length = rail.end - rail.start;
  EXPECT_NEAR(length, 0.2, 0.01);
  for (const double at : {0.35, 0.5, 0.65}) {
    const Vector3d x = result.shapes[0].position(rail.start + at * length);
    EXPECT_NEAR(std::hypot(x.x(), x.z() + kCrown), kCrown + kRadius, 3e-5) << at;
  }
  const double tension = -(result.clip_reactions[0].force.x() + result.contacts[0].force.x());
  const double expected = 0.5 * length * (tension / (kCrown + kRadius) + kWeight);
  double borne = 0.0, most = 0.0;
  for (const ContactForce& place : rail.places) {
    const double from_ends = std::min(place.arc_length - rail.start, rail.end - place.arc_length);
    if (from_ends < 0.25 * length) continue;
    borne += place.force;
    most = std::max(most, place.force);
  }
  EXPECT_NEAR(borne, expected, 2.0 * most);
  EXPECT_LT(most, 0.25 * borne);
  // all forces balance, each by each
  Vector3d sum(0.0, 0.0, -kWeight * scene.harness.cables[0].length);
  for (const ContactInterval& each : result.contacts) sum += each.force;
  for (const Reaction& clip : result.clip_reactions) sum += clip.force;
  EXPECT_LT(sum.norm(), 1e-4);
}

// Where a cable lies along a part, shapes solved anew two steps away tell the derivatives.
TEST(ShippedContact, DerivativesAlongTheRailAreThoseOfSolvedShapes) {
  const Scene scene = shipped("rail");
  StabilityOptions options;
  options.variables = {0};
  options.low_high = false;
  EquilibriumOptions accuracy;
  accuracy.accuracy = kAccuracy;
  EquilibriumSolver solver(accuracy);
  const Equilibrium nominal = solver.solve(scene.harness);
  const ComponentPoses components = componentPosesAt(scene, {});
  const MeasureEvaluator evaluator(scene, {scene.harness, nominal, components});
  const StabilityAnalysis analysis = analyseStability(scene, evaluator, options, solver);
  ASSERT_TRUE(analysis.nominal.converged());
  const double step = 0.2 * scene.design_variables[0].upper;
  const auto pressedAt = [&](double longer) {
    double total = 0.0;
    for (const ContactInterval& each :
         solved(harnessAt(scene, {{"length", scene.design_variables[0].nominal + longer}})).contacts)
      total += each.total;
    return total;
  };
  const double slope = (pressedAt(step) - pressedAt(-step)) / (2.0 * step);
  ASSERT_EQ(scene.measures[analysis.measures[0]].name, "pressed");
  EXPECT_NEAR(analysis.jacobian(0, 0), slope, 0.1 * std::abs(slope));
}

}  // namespace
}  // namespace cable_variation
