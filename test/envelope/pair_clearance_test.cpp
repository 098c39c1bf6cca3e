// Clearances of two cables: against closed forms, and against harnesses drawn and solved apart from the
// search.
#include <cable_variation/envelope/clearance/envelope_clearance.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <string>

#include <gtest/gtest.h>

#include <cable_variation/envelope/clearance/closest_solved.h>
#include <cable_variation/envelope/statistical_envelope.h>
#include <cable_variation/math/normal.h>
#include <cable_variation/measures/cable_view.h>
#include <cable_variation/measures/joint_between.h>
#include <cable_variation/scene_file/scene_reader.h>
#include <cable_variation/tolerances/tolerance_space.h>

#include "envelope_scenes.h"
#include "test_packages.h"

namespace cable_variation::test {
namespace {

using Eigen::Vector3d;
using Kind = EnvelopeClearance::Kind;

constexpr double kDegree = M_PI / 180.0;
constexpr double kLength = 0.2, kRadius = 0.004;

// Two straight cables without weight, each held at its start only: at the origin along x, and at `at` along
// `direction`. Both clips ride on the part "plate".
Scene twoRods(const Vector3d& at, const Vector3d& direction) {
  Scene scene = freeRod(kLength, kRadius);
  Harness& harness = scene.harness;
  harness.cables.push_back(harness.cables[0]);
  harness.cables[1].name = "other";
  harness.clips.push_back(harness.clips[0]);
  harness.clips[1].name = "other_clip";
  harness.clips[1].cable = 1;
  harness.clips[1].pose = {at, Eigen::Quaterniond::FromTwoVectors(Vector3d::UnitX(), direction)};
  Component plate;
  plate.name = "plate";
  scene.components = {plate};
  scene.clip_mounts.assign(2, {"plate", Pose()});
  scene.clip_mounts[1].pose = harness.clips[1].pose;
  return scene;
}

struct Found {
  Envelope envelope;
  EnvelopeClearance pair;
};

Found between(const Scene& scene, EnvelopeOptions options = {}) {
  if (options.variables.empty()) options.variables = allOf(scene.design_variables.size());
  options.verification = 300;
  EquilibriumSolver solver = solverOf(scene);
  if (!solver.solve(scene.harness).converged()) throw std::runtime_error("not solved");
  Found found{generateEnvelope(scene, options, solver), {}};
  for (const EnvelopeClearance& each : clearances(scene, found.envelope, options, ComponentParts(), solver)) {
    if (each.other) found.pair = each;
  }
  return found;
}

// Both go up and down together by far more than the gap between them: their bodies overlap, they never do.
TEST(pair_clearance, what_moves_together_never_meets) {
  constexpr double kGap = 0.02;
  Scene scene = twoRods({0.0, 0.0, kGap}, Vector3d::UnitX());
  addVariable(scene, "lift", ComponentTranslation{0, Axis::z}, -0.03, 0.03);
  const EnvelopeClearance pair = between(scene).pair;
  EXPECT_LT(pair.between_bodies, 0.0);
  EXPECT_EQ(pair.kind, Kind::together);
  EXPECT_NEAR(pair.worst_sample, kGap - 2.0 * kRadius, 1e-7);
  EXPECT_NEAR(pair.distance, pair.worst_sample - pair.margin, 1e-12);
  EXPECT_LE(pair.margin, 1e-4);
  EXPECT_EQ(pair.random_shapes, 300U);
}

// Closest where both are at limits that neither is at for its own sake.
TEST(pair_clearance, corners_of_two_variables_meet) {
  constexpr double kGap = 0.03, kEach = 0.012;
  Scene scene = twoRods({0.0, 0.0, kGap}, Vector3d::UnitX());
  addVariable(scene, "first", ClipTranslation{0, Axis::z}, -kEach, kEach);
  addVariable(scene, "second", ClipTranslation{1, Axis::z}, -kEach, kEach);
  const EnvelopeClearance pair = between(scene).pair;
  const double expected = kGap - 2.0 * kEach - 2.0 * kRadius;
  EXPECT_NEAR(pair.worst_sample, expected, 1e-7);
  EXPECT_LE(pair.distance, expected + 1e-9);
  EXPECT_GE(pair.distance, expected - 2e-4);
  EXPECT_NEAR(pair.deviations[0], kEach, 1e-9);
  EXPECT_NEAR(pair.deviations[1], -kEach, 1e-9);
}

// The second cable turns past the tip of the first, within its tolerances and not at their limits.
TEST(pair_clearance, a_contact_inside_the_tolerances_is_found) {
  const Vector3d at(0.5 * kLength, -0.15, 0.006);
  Scene scene = twoRods(at, Vector3d::UnitY());
  scene.harness.cables[1].length = scene.harness.cables[0].length = kLength;
  addVariable(scene, "turn", ClipRotation{1, Axis::z}, -75.0 * kDegree, 60.0 * kDegree);
  DesignValues turned;
  // the nominal one points away
  EnvelopeOptions options;
  options.values["turn"] = 0.0;
  scene.harness.clips[1].pose.orientation =
      Eigen::Quaterniond::FromTwoVectors(Vector3d::UnitX(), Vector3d(-1.0, -0.3, 0.0).normalized());
  scene.clip_mounts[1].pose = scene.harness.clips[1].pose;
  const EnvelopeClearance pair = between(scene, options).pair;
  // brute force over the turn, of straight lines
  double least = 1.0;
  for (double turn = -75.0; turn <= 60.0; turn += 0.05) {
    const Vector3d along =
        (scene.harness.clips[1].pose.orientation * so3::exp({0.0, 0.0, turn * kDegree})) * Vector3d::UnitX();
    for (int i = 0; i <= 200; ++i) {
      const Vector3d point = at + kLength * i / 200.0 * along;
      const Vector3d near(std::clamp(point.x(), 0.0, kLength), 0.0, 0.0);
      least = std::min(least, (point - near).norm() - 2.0 * kRadius);
    }
  }
  EXPECT_LE(pair.distance, least + 1e-4);
  EXPECT_GE(pair.distance, least - 5e-4);
}

// The plate carries the second cable past the first: they meet for a moment only.
TEST(pair_clearance, a_contact_at_one_moment_of_a_motion_is_found) {
  Scene scene = twoRods({0.0, -0.05, 0.006}, Vector3d::UnitX());
  scene.clip_mounts[0] = {"world", Pose()};
  Motion motion;
  motion.name = "pass";
  motion.component = "plate";
  for (int i = 0; i <= 100; ++i) {
    const double y = 0.001 * i;
    motion.samples.push_back({0.01 * i, {Vector3d(0.0, y, 0.0), Eigen::Quaterniond::Identity()}});
  }
  scene.motions = {motion};
  EnvelopeOptions options;
  options.motions = {0};
  const EnvelopeClearance pair = between(scene, options).pair;
  EXPECT_NEAR(pair.worst_sample, 0.006 - 2.0 * kRadius, 1e-5);
  EXPECT_NEAR(pair.time, 0.5, 0.02);
  EXPECT_LT(pair.distance, 0.0);
  // seen from the plate or not: what never comes closer than 30 mm is not held to be
  scene.motions[0].samples.resize(21);
  const EnvelopeClearance apart = between(scene, options).pair;
  EXPECT_NEAR(apart.distance, std::hypot(0.03, 0.006) - 2.0 * kRadius, 2e-4);
}

// a -- trunk -- b: b leaves the trunk 30 mm after a, 10 mm from its own start; c hangs on b's far end.
TEST(pair_clearance, the_way_between_cables_goes_along_others) {
  Harness harness;
  const auto join = [&](std::size_t parent, double at, std::size_t child, double on_child) {
    Joint joint;
    joint.parent = parent;
    joint.child = child;
    joint.parent_arc_length = at;
    joint.child_arc_length = on_child;
    harness.joints.push_back(joint);
  };
  constexpr std::size_t kTrunk = 0, kA = 1, kB = 2, kC = 3, kAlone = 4;
  join(kTrunk, 0.05, kA, 0.0);
  join(kTrunk, 0.08, kB, 0.01);
  join(kB, 0.1, kC, 0.0);
  const auto way = [&](std::size_t first, std::size_t second) {
    return joinedAlong(harness, first, second, 0.2);
  };
  ASSERT_TRUE(way(kA, kB));
  EXPECT_EQ(way(kA, kB)->on_cable, 0.0);
  EXPECT_EQ(way(kA, kB)->on_other, 0.01);
  EXPECT_NEAR(way(kA, kB)->shortest_way, 0.2 - 0.03, 1e-15);
  EXPECT_EQ(way(kB, kA)->on_cable, 0.01);
  EXPECT_NEAR(way(kTrunk, kC)->shortest_way, 0.2 - 0.09, 1e-15);
  EXPECT_NEAR(way(kC, kA)->shortest_way, 0.2 - 0.09 - 0.03, 1e-15);
  EXPECT_NEAR(way(kTrunk, kA)->shortest_way, 0.2, 1e-15);
  EXPECT_FALSE(way(kA, kAlone));
  EXPECT_FALSE(joinedAlong(harness, kC, kA, 0.1));  // further apart than that in any case
  join(kTrunk, 0.055, kC, 0.3);                     // a loop: now c's end is nearer
  EXPECT_NEAR(way(kA, kC)->shortest_way, 0.2 - 0.005, 1e-15);
  EXPECT_EQ(way(kA, kC)->on_other, 0.3);
}

// Of a share of production.
Found ofProduction(const Scene& scene, double probability, std::uint64_t seed = 1) {
  EnvelopeOptions options;
  options.variables = allOf(scene.design_variables.size());
  options.probability = probability;
  options.verification = 0;
  options.seed = seed;
  options.frames = clearanceFrames(scene, options);
  EquilibriumSolver solver = solverOf(scene);
  if (!solver.solve(scene.harness).converged()) throw std::runtime_error("not solved");
  const ComponentParts parts;
  ClosestSolved closest(scene, options, parts, solver);
  Found found{generateEnvelope(scene, options, solver, {}, closest.witness()), {}};
  const auto pairOf = [&](const ClosestSolved* known) {
    for (const EnvelopeClearance& each :
         clearances(scene, found.envelope, options, parts, solver, {}, known)) {
      if (each.other) return each;
    }
    throw std::runtime_error("no pair");
  };
  found.pair = pairOf(nullptr);
  // what was measured on the way is the same, but for what earlier looks held
  const EnvelopeClearance known = pairOf(&closest);
  EXPECT_LE(known.distance, found.pair.distance + 1e-7);
  EXPECT_EQ(known.kind, Kind::production);
  return found;
}

TEST(pair_clearance, of_production_what_moves_together_never_meets) {
  constexpr double kGap = 0.02;
  Scene scene = twoRods({0.0, 0.0, kGap}, Vector3d::UnitX());
  addVariable(scene, "lift", ComponentTranslation{0, Axis::z}, -0.03, 0.03);
  const EnvelopeClearance pair = ofProduction(scene, 0.99).pair;
  EXPECT_LT(pair.between_bodies, 0.0);
  EXPECT_EQ(pair.kind, Kind::production);
  EXPECT_NEAR(pair.worst_sample, kGap - 2.0 * kRadius, 1e-7);
  EXPECT_EQ(pair.distance, pair.worst_sample);
}

// One rod goes up and down by a normal distribution: the distance that a share keeps is a quantile.
TEST(pair_clearance, of_production_is_a_distance_that_the_share_keeps) {
  constexpr double kTolerance = 0.006, kSigma = kTolerance / 3.0, kGap = 2.0 * kRadius + 0.0035;
  Scene scene = twoRods({0.0, 0.0, kGap}, Vector3d::UnitX());
  addVariable(scene, "lift", ClipTranslation{1, Axis::z}, -kTolerance, kTolerance);
  constexpr double kProbability = 0.98;
  int more = 0;
  constexpr int kSeeds = 8;
  for (int seed = 1; seed <= kSeeds; ++seed) {
    const Found found = ofProduction(scene, kProbability, static_cast<std::uint64_t>(seed));
    const double closer = normalShare((found.pair.distance - (kGap - 2.0 * kRadius)) / kSigma);
    if (closer > 1.0 - kProbability) ++more;
    EXPECT_GT(closer, 0.1 * (1.0 - kProbability)) << "much less than production does";
    // 4 % of production meet: an envelope of 98 % holds some of them
    EXPECT_LT(found.pair.distance, 0.0);
    EXPECT_EQ(found.pair.distance, found.pair.worst_sample);
  }
  EXPECT_LE(more, 2);  // each with at most 5 % probability
  // and one of 60 % none
  EXPECT_GT(ofProduction(scene, 0.6).pair.distance, 0.0);
}

// The least distance of two cables by brute force along both, apart from where they hang together; and again
// more closely about where it was found, for where that ends the distance falls as fast as the cables part.
double leastBetween(const Harness& harness, const Equilibrium& equilibrium, const EnvelopeClearance& pair) {
  const CableShape &first = equilibrium.shapes[pair.cable], &second = equilibrium.shapes[*pair.other];
  const double way = 4.0 * (first.radius + second.radius);
  const auto joint = jointBetween(harness, pair.cable, *pair.other);
  if (!joint) throw std::runtime_error("not joined");
  double least = 1.0, at_s = 0.0, at_t = 0.0;
  const auto look = [&](double from_s, double to_s, double from_t, double to_t, double step) {
    std::vector<Vector3d> points;
    for (double t = from_t; t <= to_t; t += step) points.push_back(second.position(t));
    for (double s = from_s; s <= to_s; s += step) {
      const Vector3d point = first.position(s);
      for (std::size_t k = 0; k < points.size(); ++k) {
        const double t = from_t + static_cast<double>(k) * step;
        if (std::abs(s - joint->on_first) + std::abs(t - joint->on_second) < way) continue;
        const double distance = (point - points[k]).norm() - first.radius - second.radius;
        if (distance >= least) continue;
        least = distance;
        at_s = s;
        at_t = t;
      }
    }
  };
  const double first_length = first.points.back().arc_length, second_length = second.points.back().arc_length;
  constexpr double kStep = 0.002, kFine = 0.0001;
  look(0.0, first_length, 0.0, second_length, kStep);
  look(std::max(0.0, at_s - kStep), std::min(first_length, at_s + kStep), std::max(0.0, at_t - kStep),
       std::min(second_length, at_t + kStep), kFine);
  return least;
}

Scene shipped(const std::string& name) {
  const std::string root = CABLE_VARIATION_SOURCE_DIR;
  return readScene(root + "/config/" + name + ".yaml", [&](const std::string&) { return root; });
}

// All that its design varies, by shapes drawn here by other means.
TEST(pair_clearance, of_production_of_the_shipped_harness_is_true_and_warns_of_nothing) {
  const Scene scene = shipped("harness");
  constexpr double kProbability = 0.98;
  const Found found = ofProduction(scene, kProbability);
  EXPECT_EQ(found.pair.kind, Kind::production);
  EXPECT_GT(found.pair.distance, 0.0);
  EXPECT_EQ(found.pair.random_shapes, found.envelope.containment.shapes - found.envelope.containment.outside);

  EquilibriumSolver solver = solverOf(scene);
  ASSERT_TRUE(solver.solve(scene.harness).converged());
  // the distance that was found belongs to the deviations told
  const auto at = [&](const Eigen::VectorXd& deviations) {
    DesignValues values;
    for (std::size_t k = 0; k < scene.design_variables.size(); ++k) {
      const DesignVariable& variable = scene.design_variables[k];
      values[variable.name] = variable.nominal + deviations[static_cast<Eigen::Index>(k)];
    }
    const Harness harness = harnessAt(scene, values);
    EquilibriumSolver aside = solver;
    const Equilibrium equilibrium = aside.update(harness);
    if (!equilibrium.converged()) throw std::runtime_error("not solved");
    return leastBetween(harness, equilibrium, found.pair);
  };
  EXPECT_NEAR(at(found.pair.deviations), found.pair.distance, 2e-4);
  // harnesses as they are made
  std::mt19937_64 random(11);
  std::normal_distribution<double> normal;
  std::uniform_real_distribution<double> even(-1.0, 1.0);
  constexpr int kDrawn = 1500;
  int closer = 0;
  for (int i = 0; i < kDrawn; ++i) {
    Eigen::VectorXd deviations(static_cast<Eigen::Index>(scene.design_variables.size()));
    for (Eigen::Index k = 0; k < deviations.size(); ++k) {
      const DesignVariable& variable = scene.design_variables[static_cast<std::size_t>(k)];
      const double tolerance = variable.upper;
      if (variable.distribution == "uniform") {
        deviations[k] = tolerance * even(random);
      } else if (variable.distribution == "triangular") {
        deviations[k] = 0.5 * tolerance * (even(random) + even(random));
      } else {
        deviations[k] = tolerance / 3.0 * normal(random);
      }
    }
    if (at(deviations) < found.pair.distance) ++closer;
  }
  EXPECT_LE(closer, (1.0 - kProbability) * kDrawn);
}

// Shipped, with its breakout: what is told holds for harnesses drawn and solved here, and is no false alarm.
TEST(pair_clearance, of_shipped_harnesses_holds_and_warns_of_nothing) {
  for (const std::string name : {"harness", "harness_clipped"}) {
    const Scene scene = shipped(name);
    EnvelopeOptions options;
    options.variables = {0, 1, 2, 5, 6, 7};
    const Found found = between(scene, options);
    const EnvelopeClearance& pair = found.pair;
    EXPECT_EQ(pair.kind, Kind::together) << name;
    EXPECT_GT(pair.distance, 0.0) << name;
    EXPECT_LE(pair.distance, pair.worst_sample) << name;

    const ToleranceSpace tolerances(scene, options.variables);
    const CounterRandom random(77, 1);
    EquilibriumSolver solver = solverOf(scene);
    ASSERT_TRUE(solver.solve(scene.harness).converged());
    double least = 1.0;
    for (std::uint64_t i = 0; i < 400; ++i) {
      RandomRow numbers(random, i);
      const Eigen::VectorXd deviations =
          i % 2 == 0 ? tolerances.random(numbers) : tolerances.randomNearLimits(numbers);
      DesignValues values;
      for (std::size_t k = 0; k < options.variables.size(); ++k) {
        const DesignVariable& variable = scene.design_variables[options.variables[k]];
        values[variable.name] = variable.nominal + deviations[static_cast<Eigen::Index>(k)];
      }
      EquilibriumSolver aside = solver;
      const Harness harness = harnessAt(scene, values);
      const Equilibrium drawn = aside.update(harness);
      ASSERT_TRUE(drawn.converged());
      least = std::min(least, leastBetween(harness, drawn, pair));
    }
    EXPECT_LE(pair.distance, least) << name;
    EXPECT_GE(pair.distance, least - 2e-3) << name;
  }
}

}  // namespace
}  // namespace cable_variation::test
