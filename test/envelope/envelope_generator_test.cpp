// Envelopes against closed forms of swept bodies, against shapes drawn and solved apart from them, and what
// is refused.
#include <cable_variation/envelope/envelope_generator.h>

#include <cmath>
#include <stdexcept>
#include <string>

#include <gtest/gtest.h>

#include <cable_variation/envelope/search/random_place.h>
#include <cable_variation/measures/cable_view.h>
#include <cable_variation/scene_file/scene_reader.h>
#include <cable_variation/statistics/confidence.h>
#include <cable_variation/tolerances/tolerance_space.h>
#include <cable_variation/util/error.h>

#include "envelope_scenes.h"
#include "test_packages.h"

namespace cable_variation::test {
namespace {

using Eigen::Vector3d;

constexpr double kDegree = M_PI / 180.0;
// The share of a volume by which the default voxels may miss it: they are a sixth of a radius wide, and the
// errors of cut ones cancel but for some per cent of them.
constexpr double kVoxelError = 0.01;

Envelope generate(const Scene& scene, EnvelopeOptions options) {
  if (options.variables.empty()) options.variables = allOf(scene.design_variables.size());
  return generateEnvelope(scene, options, solverOf(scene));
}

EnvelopeOptions exactly() {
  EnvelopeOptions options;
  options.conservative = false;
  options.margin = 2e-5;
  options.verification = 300;
  options.tightness = 1;  // for the envelope's own volume
  return options;
}

double ballVolume(double radius) { return 4.0 / 3.0 * M_PI * std::pow(radius, 3); }
double capsuleVolume(double length, double radius) {
  return M_PI * radius * radius * length + ballVolume(radius);
}

TEST(envelope_generator, of_a_box_of_translations_is_the_rounded_box) {
  constexpr double kLength = 0.1, kRadius = 0.004, kX = 0.006, kY = 0.004, kZ = 0.002;  // tolerances +-
  Scene scene = freeRod(kLength, kRadius);
  addVariable(scene, "x", ClipTranslation{0, Axis::x}, -kX, kX);
  addVariable(scene, "y", ClipTranslation{0, Axis::y}, -kY, kY);
  addVariable(scene, "z", ClipTranslation{0, Axis::z}, -kZ, kZ);
  const Envelope envelope = generate(scene, exactly());
  // Steiner's formula for a box rounded by a ball
  const double a = kLength + 2.0 * kX, b = 2.0 * kY, c = 2.0 * kZ, r = kRadius;
  const double volume =
      a * b * c + 2.0 * (a * b + b * c + c * a) * r + M_PI * (a + b + c) * r * r + ballVolume(r);
  EXPECT_NEAR(envelope.tightness.envelope_volume, volume, kVoxelError * volume);
  EXPECT_EQ(envelope.containment.outside, 0U);
  EXPECT_LE(envelope.containment.largest_protrusion, 1e-6);  // translations are linear: corners say it all
  EXPECT_EQ(envelope.failures, 0U);
}

TEST(envelope_generator, of_a_ball_of_translations_is_the_thicker_capsule) {
  constexpr double kLength = 0.1, kRadius = 0.004, kBall = 0.005;
  Scene scene = freeRod(kLength, kRadius);
  for (const Axis axis : {Axis::x, Axis::y, Axis::z}) {
    addVariable(scene, "t" + std::to_string(static_cast<int>(axis)), ClipTranslation{0, axis}, -kBall, kBall);
  }
  scene.tolerance_regions.push_back({"ball", ToleranceRegion::Shape::ball, {0, 1, 2}, kBall, true, 3.0});
  EnvelopeOptions options = exactly();
  options.margin = 1e-4;
  const Envelope envelope = generate(scene, options);
  const double volume = capsuleVolume(kLength, kRadius + kBall);
  EXPECT_NEAR(envelope.tightness.envelope_volume, volume, 2.0 * kVoxelError * volume);
  EXPECT_LE(envelope.containment.largest_protrusion, options.margin);
  // the corners of the box around the ball are no part of it
  const Vector3d corner = Vector3d(-1.0, -1.0, -1.0).normalized() * (kBall + kRadius + 2e-4);
  EXPECT_GT(outside(envelope.frames[0].pieces, corner), 0.0);
}

// The tip of a rod that turns by +-angle is furthest out in the middle, where neither limit is.
TEST(envelope_generator, extremes_inside_the_tolerances_are_found) {
  constexpr double kLength = 0.3, kRadius = 0.004, kAngle = 20.0 * kDegree;
  Scene scene = freeRod(kLength, kRadius);
  addVariable(scene, "turn", ClipRotation{0, Axis::z}, -kAngle, kAngle);
  EnvelopeOptions options = exactly();
  options.margin = 1e-4;
  const Envelope envelope = generate(scene, options);
  const auto& pieces = envelope.frames[0].pieces;
  EXPECT_LE(outside(pieces, {kLength + kRadius, 0.0, 0.0}), options.margin);
  EXPECT_GE(outside(pieces, {kLength + kRadius + 1e-3, 0.0, 0.0}), 1e-3 - 1e-5);
  for (double angle = -kAngle; angle <= kAngle; angle += kDegree) {
    const Vector3d tip = (kLength + kRadius) * Vector3d(std::cos(angle), std::sin(angle), 0.0);
    EXPECT_LE(outside(pieces, tip), options.margin) << angle;
  }
  EXPECT_LE(envelope.containment.largest_protrusion, options.margin);
}

Scene harnessCase() {
  return readScene(std::string(CABLE_VARIATION_SOURCE_DIR) + "/config/harness.yaml",
                   [](const std::string&) { return std::string(CABLE_VARIATION_SOURCE_DIR); });
}

// Drawn and solved here, by the services' own way, not by the generator's.
TEST(envelope_generator, holds_every_harness_that_is_drawn_afterwards) {
  const Scene scene = harnessCase();
  EnvelopeOptions options;
  options.variables = {0, 1, 2, 3, 4};
  options.tightness = 1500;
  const EquilibriumSolver solver = [&] {
    EquilibriumSolver made = solverOf(scene);
    made.solve(scene.harness);
    return made;
  }();
  const Envelope envelope = generateEnvelope(scene, options, solver);
  // shapes drawn after the envelope was finished: some could be outside, as a coarser one shows below
  EXPECT_EQ(envelope.containment.shapes, options.verification);
  EXPECT_LE(envelope.containment.outside, 1U);
  EXPECT_EQ(envelope.containment.outside_bound,
            shareUpperBound(envelope.containment.outside, options.verification, 0.95));
  EXPECT_EQ(envelope.containment.largest_excess > 0.0, envelope.containment.outside > 0);
  EXPECT_GT(envelope.inflation, 0.0);
  EXPECT_LE(envelope.tightness.ratio(), 1.05);
  EXPECT_GE(envelope.tightness.ratio(), 1.0);

  const ToleranceSpace tolerances(scene, options.variables);
  const CounterRandom random(20, 1);
  for (int i = 0; i < 300; ++i) {
    RandomRow numbers(random, static_cast<std::uint64_t>(i));
    const Eigen::VectorXd deviations =
        i % 2 == 0 ? tolerances.random(numbers) : tolerances.randomNearLimits(numbers);
    DesignValues values;
    for (std::size_t k = 0; k < options.variables.size(); ++k) {
      values[scene.design_variables[k].name] = deviations[static_cast<Eigen::Index>(k)];
    }
    EquilibriumSolver aside = solver;
    const Equilibrium drawn = aside.update(harnessAt(scene, values));
    ASSERT_TRUE(drawn.converged());
    for (const CableShape& shape : drawn.shapes) {
      for (double s = 0.0; s < shape.points.back().arc_length; s += 0.0037) {
        EXPECT_LE(outside(envelope.frames[0].pieces, shape.position(s)), -shape.radius) << i << ' ' << s;
      }
    }
  }
}

// What is told of a coarse envelope that is not inflated is what independent shapes tell of its pieces.
TEST(envelope_generator, tells_how_many_shapes_stick_out_of_a_coarse_one) {
  const Scene scene = harnessCase();
  EnvelopeOptions options;
  options.variables = {1, 2, 5};
  options.conservative = false;
  options.margin = 2e-3;
  options.verification = 1000;
  EquilibriumSolver solver = solverOf(scene);
  ASSERT_TRUE(solver.solve(scene.harness).converged());
  const Envelope envelope = generateEnvelope(scene, options, solver);
  const Containment& told = envelope.containment;
  EXPECT_EQ(envelope.inflation, 0.0);
  EXPECT_GT(told.outside, 0U);
  EXPECT_EQ(told.largest_excess, told.largest_protrusion);
  EXPECT_GT(told.outside_bound, static_cast<double>(told.outside) / static_cast<double>(told.shapes));

  const SampleSpace space(scene, options);
  const CounterRandom random(77, 9);
  constexpr int kDrawn = 400;
  int outside_here = 0;
  double largest = 0.0;
  for (int i = 0; i < kDrawn; ++i) {
    EquilibriumSolver aside = solver;
    const Harness harness = space.harness(drawPlace(space, 0.0, 0.0, random, static_cast<std::uint64_t>(i)));
    const Equilibrium drawn = aside.update(harness);
    ASSERT_TRUE(drawn.converged());
    double out = 0.0;
    for (const CableShape& shape : drawn.shapes) {
      for (double s = 0.0; s < shape.points.back().arc_length; s += 0.002)
        out = std::max(out, outside(envelope.frames[0].pieces, shape.position(s)) + shape.radius);
    }
    largest = std::max(largest, out);
    if (out > 1e-6) ++outside_here;
  }
  const double share = static_cast<double>(outside_here) / kDrawn;
  const double observed = static_cast<double>(told.outside) / static_cast<double>(told.shapes);
  const double error = std::sqrt(std::max(share, 0.01) * (1.0 / kDrawn + 1.0 / 1000.0));
  EXPECT_NEAR(observed, share, 4.0 * error + 0.01);
  EXPECT_LE(largest, 2.0 * told.largest_excess + 1e-4);
}

TEST(envelope_generator, does_not_depend_on_threads) {
  Scene scene = freeRod(0.2, 0.004);
  addVariable(scene, "turn", ClipRotation{0, Axis::z}, -0.2, 0.3);
  addVariable(scene, "lift", ClipRotation{0, Axis::y}, -0.2, 0.1);
  EnvelopeOptions options = exactly();
  options.margin = 5e-4;
  options.tightness = 50;
  options.threads = 1;
  const Envelope one = generate(scene, options);
  options.threads = 2;
  const Envelope two = generate(scene, options);
  EXPECT_EQ(one.solves, two.solves);
  EXPECT_EQ(one.containment.largest_protrusion, two.containment.largest_protrusion);
  EXPECT_EQ(one.tightness.shapes_volume, two.tightness.shapes_volume);
  ASSERT_EQ(one.frames[0].pieces.size(), two.frames[0].pieces.size());
  for (std::size_t i = 0; i < one.frames[0].pieces.size(); ++i) {
    EXPECT_EQ(one.frames[0].pieces[i].body.core.surface().vertices,
              two.frames[0].pieces[i].body.core.surface().vertices);
  }
}

TEST(envelope_generator, is_split_where_the_cable_snaps) {
  const Scene scene = bowedStrip();
  EnvelopeOptions options = exactly();
  options.margin = 5e-4;
  options.verification = 100;
  const Envelope envelope = generate(scene, options);
  ASSERT_EQ(envelope.snaps.size(), 1U);  // one for the pair of branches, however many jumps were found
  EXPECT_EQ(envelope.branches, 2U);
  const Snap& snap = envelope.snaps.front();
  EXPECT_EQ(snap.branch, 1U);
  EXPECT_NEAR(snap.begins, snap.after[0] / scene.design_variables[0].lower, 1e-12);
  // all that is turned further than where it begins has snapped: of 85 degrees, evenly
  const double beyond = (snap.after[0] - scene.design_variables[0].lower) / (85.0 * kDegree);
  EXPECT_NEAR(snap.share, beyond, 4.0 * std::sqrt(beyond * (1.0 - beyond) / 50.0));
  EXPECT_GT(snap.share_bound, snap.share);
  EXPECT_LT(std::abs(snap.before[0] - snap.after[0]), 1.0 * kDegree);
  EXPECT_LT(snap.before[0], 0.0);
  // half way between the shapes before and after there is nothing
  EquilibriumSolver solver = solverOf(scene);
  ASSERT_TRUE(solver.solve(scene.harness).converged());
  double height_before = 0.0, height_after = 0.0;
  for (double turn = 0.0; turn > snap.after[0] - kDegree; turn -= 0.5 * kDegree) {
    const Equilibrium found = solver.update(harnessAt(scene, {{"turn", turn}}));
    ASSERT_TRUE(found.converged());
    const double height = found.shapes[0].position(snap.arc_length).y();
    (turn > snap.before[0] ? height_before : height_after) = height;
  }
  const double jump = std::abs(height_before - height_after);
  EXPECT_GT(jump, 0.03);
  EXPECT_NEAR(jump, snap.jump, 0.2 * jump);
  EquilibriumSolver again = solverOf(scene);
  again.solve(scene.harness);
  const Vector3d before =
      again.update(harnessAt(scene, {{"turn", snap.before[0]}})).shapes[0].position(snap.arc_length);
  const Vector3d between(before.x(), 0.5 * (height_before + height_after), 0.0);
  EXPECT_GT(outside(envelope.frames[0].pieces, between), 0.1 * jump);
}

// A rod parallel to the axis about which its component turns.
Scene turningRod(double reach, double length, double radius, double angle, int poses) {
  Scene scene = freeRod(length, radius);
  Component arm;
  arm.name = "arm";
  scene.components = {arm};
  const Pose upright{Vector3d(reach, 0.0, 0.0), so3::exp({0.0, -0.5 * M_PI, 0.0})};
  scene.clip_mounts[0] = {"arm", upright};
  scene.harness.clips[0].pose = upright;
  Motion motion;
  motion.name = "turn";
  motion.component = "arm";
  for (int i = 0; i < poses; ++i) {
    const double share = i / (poses - 1.0);
    motion.samples.push_back({2.0 * share, {Vector3d::Zero(), so3::exp({0.0, 0.0, angle * share})}});
  }
  scene.motions = {motion};
  return scene;
}

TEST(envelope_generator, over_a_turn_is_the_body_of_revolution) {
  constexpr double kReach = 0.15, kLength = 0.05, kRadius = 0.008, kAngle = 150.0 * kDegree;
  for (const int poses : {5, 2000}) {
    const Scene scene = turningRod(kReach, kLength, kRadius, kAngle, poses);
    EnvelopeOptions options = exactly();
    options.motions = {0};
    options.margin = 2e-4;
    const Envelope envelope = generate(scene, options);
    EXPECT_GT(envelope.phases.size(), 10U);
    EXPECT_EQ(envelope.phases.front().start, 0.0);
    EXPECT_EQ(envelope.phases.back().end, 2.0);
    // Pappus: half a capsule's section on each side of the arc, and half a capsule at each end of it. Between
    // recorded poses the motion itself takes the position's chord, here zero.
    const double section = 2.0 * kRadius * kLength + M_PI * kRadius * kRadius;
    const double volume = section * kReach * kAngle + capsuleVolume(kLength, kRadius);
    // phases as far as half a radius: their hulls fill the arc's sagitta
    EXPECT_NEAR(envelope.tightness.envelope_volume, volume, 0.015 * volume) << poses;
    EXPECT_LE(envelope.containment.largest_protrusion, options.margin) << poses;
    EXPECT_GT(outside(envelope.frames[0].pieces, Vector3d::Zero()), 0.5 * kReach);
  }
}

TEST(envelope_generator, seen_from_the_component_that_carries_it_a_rigid_cable_stands_still) {
  constexpr double kReach = 0.15, kLength = 0.05, kRadius = 0.008;
  const Scene scene = turningRod(kReach, kLength, kRadius, 1.0, 50);
  EnvelopeOptions options = exactly();
  options.motions = {0};
  options.frames = {"arm"};
  options.margin = 1e-4;
  const Envelope envelope = generate(scene, options);
  ASSERT_EQ(envelope.frames.size(), 2U);
  EXPECT_EQ(envelope.frames[1].component, "arm");
  for (const EnvelopePiece& piece : envelope.frames[1].pieces) {
    for (const Vector3d& vertex : piece.body.core.surface().vertices) {
      EXPECT_NEAR(vertex.x(), kReach, 2e-6);  // thin hulls get a body of a micrometre
      EXPECT_NEAR(vertex.y(), 0.0, 2e-6);
    }
  }
}

TEST(envelope_generator, solves_a_sample_again) {
  Scene scene = freeRod(0.2, 0.004);
  addVariable(scene, "turn", ClipRotation{0, Axis::z}, -0.2, 0.3);
  EnvelopeOptions options = exactly();
  options.variables = {0};
  const Envelope envelope = generate(scene, options);
  for (const EnvelopeSample& sample : envelope.samples) {
    const SolvedSample solved = solveSample(scene, options, envelope, sample, solverOf(scene));
    ASSERT_TRUE(solved.equilibrium.converged());
    const Vector3d tip = solved.equilibrium.shapes[0].points.back().pose.position;
    EXPECT_NEAR(std::atan2(tip.y(), tip.x()), sample.deviations[0], 1e-9);
  }
}

TEST(envelope_generator, reports_progress_and_stops_when_asked) {
  Scene scene = freeRod(0.2, 0.004);
  addVariable(scene, "turn", ClipRotation{0, Axis::z}, -0.2, 0.3);
  EnvelopeOptions options = exactly();
  options.variables = {0};
  std::vector<double> shares;
  generateEnvelope(scene, options, solverOf(scene), [&](const Progress& progress) {
    shares.push_back(progress.share);
    return true;
  });
  ASSERT_GT(shares.size(), 3U);
  EXPECT_GE(shares.front(), 0.0);
  EXPECT_LE(shares.back(), 1.0);
  for (std::size_t stop = 1; stop < shares.size(); stop += 2) {
    std::size_t calls = 0;
    EXPECT_THROW(
        generateEnvelope(scene, options, solverOf(scene), [&](const Progress&) { return ++calls < stop; }),
        Cancelled);
    EXPECT_EQ(calls, stop);
  }
}

TEST(envelope_generator, of_a_design_that_no_equilibrium_can_exist_for_says_so) {
  Scene scene = bowedStrip();  // between clips 0.26 m apart
  addVariable(scene, "length", CableProperty{0, CableProperty::Property::length}, -0.001, 0.001);
  scene.design_variables.back().nominal = scene.harness.cables[0].length;
  EnvelopeOptions options = exactly();
  options.variables = {0, 1};
  options.values["length"] = 0.2;
  EXPECT_THROW(generateEnvelope(scene, options, solverOf(scene)), Impossible);
}

std::string refusal(const Scene& scene, const EnvelopeOptions& options) {
  try {
    generateEnvelope(scene, options, solverOf(scene));
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "";
}

TEST(envelope_generator, refuses_what_is_no_envelope) {
  Scene scene = turningRod(0.15, 0.05, 0.004, 1.0, 3);
  addVariable(scene, "turn", ClipRotation{0, Axis::z}, -0.2, 0.3);
  EnvelopeOptions sound;
  sound.variables = {0};
  EXPECT_EQ(refusal(scene, sound), "");
  const auto expectRefusal = [&](const EnvelopeOptions& options, const std::string& part) {
    const std::string message = refusal(scene, options);
    EXPECT_NE(message.find(part), std::string::npos) << message << " lacks " << part;
  };
  EnvelopeOptions bad = sound;
  bad.variables = {};
  expectRefusal(bad, "nothing varies");
  bad.variables = {7};
  expectRefusal(bad, "design variable number 7");
  bad.variables = {0, 0};
  expectRefusal(bad, "given twice");
  bad = sound;
  bad.margin = -1e-3;
  expectRefusal(bad, "margin: -0.001 m; expected above 0");
  bad = sound;
  bad.cables = {3};
  expectRefusal(bad, "cable number 3");
  bad = sound;
  bad.motions = {1};
  expectRefusal(bad, "motion number 1");
  bad = sound;
  bad.verification = 0;
  expectRefusal(bad, "verification");
  bad = sound;
  bad.motions = {0};
  bad.from = 1.0;
  bad.to = 0.5;
  expectRefusal(bad, "times in order");
  bad.motions = {0};
  bad.from = -1.0;
  expectRefusal(bad, "at least 0 s");
  bad = sound;
  bad.frames = {"nowhere"};
  expectRefusal(bad, "nowhere");
  scene.motions[0].samples.clear();
  bad = sound;
  bad.motions = {0};
  expectRefusal(bad, "motion 'turn' has no poses");
}

}  // namespace
}  // namespace cable_variation::test
