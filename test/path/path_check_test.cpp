// Equilibria along a path: each one is that of the harness there, and what happens on the way is told where
// it happens. Oracles: plain steps twenty and more times finer, geometry.
#include <cable_variation/path/path_check.h>

#include <cmath>
#include <random>
#include <stdexcept>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include <cable_variation/scene_file/scene_reader.h>
#include <cable_variation/util/error.h>
#include <test_packages.h>

namespace cable_variation::test {
namespace {

using Eigen::Vector3d;

Design designOf(const std::string& file) {
  return {readScene(std::string(CABLE_VARIATION_SOURCE_DIR) + "/" + file, findTestPackage), {}};
}

EquilibriumSolver solverOf(const Scene& scene) {
  EquilibriumOptions options;
  options.accuracy = scene.accuracy;
  return EquilibriumSolver(options);
}

/// A design as it is loaded, and its shape.
struct AtRest {
  explicit AtRest(Design of)
      : design(std::move(of)),
        harness(harnessAt(design, {})),
        solver(solverOf(design.scene)),
        equilibrium(solver.solve(harness)),
        components(componentPosesAt(design.scene, design.shifted)),
        evaluator(design.scene, {harness, equilibrium, components}) {}
  AtRest(const AtRest&) = delete;

  PathCheck check(const ComponentPath& path, double step = 5e-3, bool attachments = false) const {
    PathTask task;
    task.design = design;
    task.solver = solver;
    task.path = path;
    task.step = step;
    task.attachments = attachments;
    return checkPath(std::move(task), evaluator);
  }

  Design design;
  Harness harness;
  EquilibriumSolver solver;
  Equilibrium equilibrium;
  ComponentPoses components;
  MeasureEvaluator evaluator;
};

Pose turned(const Vector3d& position, double angle, const Vector3d& axis) {
  return {position, Eigen::Quaterniond(Eigen::AngleAxisd(angle, axis))};
}

const TimedEvent* firstOf(const PathCheck& check, ShapeEvent::Kind kind) {
  for (const TimedEvent& each : check.events) {
    if (each.event.kind == kind) return &each;
  }
  return nullptr;
}

TEST(PathCheck, EachSampleIsTheEquilibriumThere) {
  const AtRest strand(designOf("test/ros/data/attachments.yaml"));
  const ComponentPath path = pathOfComponent(
      strand.design, {}, "holder",
      {{0.0, {{0.25, 0, 0}}}, {1.0, {{0.24, 0.02, 0.0}}}, {3.0, turned({0.21, 0.04, 0.01}, 0.3, {0, 0, 1})}});
  const PathCheck check = strand.check(path);
  EXPECT_TRUE(check.kept);
  for (const TimedEvent& each : check.events) ADD_FAILURE() << each.time << ": " << each.event.text;
  EXPECT_TRUE(check.warnings.empty());
  ASSERT_GT(check.samples.size(), 15u);
  const double way = Vector3d(0.01, 0.02, 0.0).norm() + Vector3d(0.03, 0.02, 0.01).norm();
  EXPECT_NEAR(check.samples.back().length, way, 1e-12);
  EquilibriumSolver oracle = strand.solver;
  double oracle_time = 0.0;
  const auto inFineSteps = [&](double time) {
    constexpr int kSteps = 20;
    Equilibrium found;
    for (int i = 1; i <= kSteps; ++i) {
      const double at = oracle_time + (time - oracle_time) * i / kSteps;
      found = oracle.update(harnessAt(strand.design, {}, path.places(at)));
    }
    oracle_time = time;
    return found;
  };
  double before = -1.0;
  for (const PathSample& sample : check.samples) {
    EXPECT_GT(sample.time, before);
    before = sample.time;
    const Equilibrium expected = inFineSteps(sample.time);
    ASSERT_TRUE(expected.converged() && sample.solved);
    for (std::size_t k = 0; k < sample.centrelines[0].size(); ++k) {
      const double s = 0.312 * static_cast<double>(k) / static_cast<double>(sample.centrelines[0].size() - 1);
      EXPECT_LT((sample.centrelines[0][k] - expected.shapes[0].position(s)).norm(), 2e-4);
    }
    const double force = expected.clip_reactions[1].force.norm();
    EXPECT_NEAR(sample.reactions[1].force.norm(), force, 2e-3 * force + 1e-3);
    EXPECT_EQ(sample.measures[0].value, sample.reactions[1].force.norm());
    EXPECT_NEAR(sample.smallest_eigenvalue, expected.smallest_eigenvalue,
                5e-3 * expected.smallest_eigenvalue);
    EXPECT_NEAR(sample.bends[0].radius, smallestBendRadius(expected.shapes[0]).radius,
                0.02 * sample.bends[0].radius);
  }
}

TEST(PathCheck, ClipsGoNoFurtherThanAStep) {
  const AtRest strand(designOf("test/ros/data/attachments.yaml"));
  const ComponentPath path =
      pathOfComponent(strand.design, {}, "holder",
                      {{0.0, {{0.25, 0, 0}}}, {2.0, turned({0.21, 0.02, 0.03}, 1.0, {0, 0, 1})}});
  for (const double step : {2e-3, 7e-3, 0.5}) {
    const PathCheck check = strand.check(path, step);
    for (std::size_t i = 1; i < check.samples.size(); ++i) {
      const Pose a = path.frame(check.samples[i - 1].time), b = path.frame(check.samples[i].time);
      EXPECT_LE((a.position - b.position).norm() + 0.05 * a.orientation.angularDistance(b.orientation),
                step * (1.0 + 1e-9));
    }
    EXPECT_EQ(check.samples.front().time, 0.0);
    EXPECT_EQ(check.samples.back().time, 2.0);
  }
}

TEST(PathCheck, ASnapIsToldWhereItIs) {
  const AtRest strip(designOf("test/ros/data/snapping.yaml"));
  constexpr double kAngle = 0.8;  // [rad], in as many seconds
  const auto angled = [](double angle) { return turned({0.3, 0, 0}, angle, {0, 1, 0}); };
  // Whichever way it bulges, the one sense of turning flips it.
  for (const double sense : {1.0, -1.0}) {
    const ComponentPath path =
        pathOfComponent(strip.design, {}, "holder", {{0.0, angled(0.0)}, {kAngle, angled(sense * kAngle)}});
    EquilibriumSolver oracle = strip.solver;
    double snapped_at = -1.0, height = strip.equilibrium.shapes[0].position(0.155).z();
    for (double angle = 0.0; angle <= kAngle && snapped_at < 0.0; angle += 5e-4) {
      const Equilibrium at = oracle.update(harnessAt(strip.design, {}, path.places(angle)));
      ASSERT_TRUE(at.converged());
      const double now = at.shapes[0].position(0.155).z();
      if (std::abs(now - height) > 0.01) snapped_at = angle;
      height = now;
    }
    const PathCheck check = strip.check(path);
    const TimedEvent* snap = firstOf(check, ShapeEvent::Kind::snapped);
    ASSERT_EQ(snap != nullptr, snapped_at >= 0.0) << sense;
    EXPECT_EQ(check.kept, false) << "the limit of z is broken on one side, the snap is on the other";
    if (snap == nullptr) continue;
    EXPECT_NEAR(snap->time, snapped_at, 0.02);
    EXPECT_GT(snap->event.distance, 0.02);
    EXPECT_LT(snap->event.to_value, snap->event.from_value);
    double least = HUGE_VAL;  // it goes to 0 there
    for (const PathSample& sample : check.samples) {
      if (sample.time < snap->time) least = std::min(least, sample.smallest_eigenvalue);
    }
    EXPECT_LT(least, 0.5 * check.samples.front().smallest_eigenvalue);
  }
}

TEST(PathCheck, WhatIsOutOfReachIsToldAndComesBack) {
  const AtRest strand(designOf("test/ros/data/attachments.yaml"));
  const ComponentPath path = pathOfComponent(
      strand.design, {}, "holder", {{0.0, {{0.25, 0, 0}}}, {1.0, {{0.35, 0, 0}}}, {2.0, {{0.25, 0, 0}}}});
  const PathCheck check = strand.check(path, 2e-3);
  const TimedEvent* lost = firstOf(check, ShapeEvent::Kind::overstretched);
  const TimedEvent* back = firstOf(check, ShapeEvent::Kind::equilibrium_back);
  ASSERT_TRUE(lost != nullptr && back != nullptr);
  EXPECT_GT(0.25 + lost->length, 0.312);  // the cable's length
  EXPECT_LT(back->time - 1.0, 1.0 - lost->time + 0.05);
  EXPECT_FALSE(check.kept);
  for (const PathSample& sample : check.samples) {
    EXPECT_EQ(sample.solved, sample.time < lost->time || sample.time >= back->time);
    EXPECT_EQ(sample.message.empty(), sample.solved);
  }
  EXPECT_TRUE(check.samples.back().solved);
  const PathWorst force = worstAlong(check, strand.design.scene.measures[0], 0);
  EXPECT_GT(force.largest, 10.0 * force.smallest);  // all but taut
  EXPECT_EQ(force.worst, force.largest);            // without limits a large force is the bad one
}

TEST(PathCheck, LimitsBrokenAndKeptAgainAreTold) {
  Design design = designOf("test/ros/data/attachments.yaml");
  design.scene.measures[1].lower = -0.05;  // height
  const AtRest strand(std::move(design));
  const double start =
      strand.evaluator.evaluate({strand.harness, strand.equilibrium, strand.components}, {1})[0].value;
  ASSERT_LT(start, 0.0);
  const ComponentPath path = pathOfComponent(
      strand.design, {}, "holder", {{0.0, {{0.25, 0, 0}}}, {1.0, {{0.1, 0, -0.1}}}, {2.0, {{0.25, 0, 0}}}});
  const PathCheck check = strand.check(path);
  bool within = true;
  std::size_t changes = 0;
  for (const PathSample& sample : check.samples) {
    const bool now = sample.measures[1].value >= -0.05;
    changes += now != within ? 1U : 0U;
    within = now;
  }
  std::size_t told = 0;
  for (const TimedEvent& each : check.events) told += each.event.measure == "height" ? 1U : 0U;
  EXPECT_GE(changes, 2u);
  const TimedEvent* broken = firstOf(check, ShapeEvent::Kind::limit_broken);
  ASSERT_NE(broken, nullptr);
  EXPECT_NE(broken->event.text.find(" mm and breaks its limits (at least -50 mm)"), std::string::npos)
      << broken->event.text;
  EXPECT_EQ(told, changes);
  EXPECT_FALSE(check.kept);
  const PathWorst worst = worstAlong(check, strand.design.scene.measures[1], 1);
  EXPECT_FALSE(worst.within);
  EXPECT_EQ(worst.worst, worst.smallest);
}

TEST(PathCheck, ClipsCloseAndOpenByTheTimeOfAMotion) {
  const AtRest strand(designOf("test/ros/data/attachments.yaml"));
  const Motion& motion = strand.design.scene.motions.front();
  const ComponentPath path = pathOfMotions(strand.design, {}, {0}, 0.0, motion.duration());
  const PathCheck check = strand.check(path, 5e-3, true);
  const TimedEvent* closed = firstOf(check, ShapeEvent::Kind::clip_closed);
  const TimedEvent* opened = firstOf(check, ShapeEvent::Kind::clip_opened);
  ASSERT_TRUE(closed != nullptr && opened != nullptr);
  EXPECT_EQ(closed->event.clip, "C");
  EXPECT_EQ(opened->event.clip, "B");
  EXPECT_EQ(closed->time, 0.5);
  for (const PathSample& sample : check.samples) {
    EXPECT_EQ(sample.reactions[2].force.norm() > 0.0, sample.time >= 0.5) << sample.time;
    EXPECT_EQ(sample.reactions[1].force.norm() > 0.0, sample.time < 0.5) << sample.time;
  }
  const PathCheck without = strand.check(path, 5e-3, false);
  EXPECT_EQ(firstOf(without, ShapeEvent::Kind::clip_closed), nullptr);
}

TEST(PathCheck, AMotionIsAPathOfItsPoses) {
  const AtRest strand(designOf("test/ros/data/attachments.yaml"));
  const Motion& motion = strand.design.scene.motions.front();
  const ComponentPath recorded = pathOfMotions(strand.design, {}, {0}, 0.0, motion.duration());
  const ComponentPath given = pathOfComponent(strand.design, {}, "holder", motion.samples);
  const PathCheck a = strand.check(recorded), b = strand.check(given);
  EXPECT_NEAR(a.samples.back().length, b.samples.back().length, 1e-9);
  EXPECT_NEAR(a.samples.back().reactions[1].force.norm(), b.samples.back().reactions[1].force.norm(), 1e-3);
}

/// Whatever deviations a design has, the frame that was asked takes the poses.
TEST(ComponentPath, TheFrameTakesThePoses) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> share(-1.0, 1.0);
  const auto vectorOf = [&](double size) {
    return Vector3d(size * Vector3d::NullaryExpr([&] { return share(random); }));
  };
  const auto poseOf = [&](double size, double angle) {
    return Pose{vectorOf(size),
                Eigen::Quaterniond(Eigen::AngleAxisd(angle * share(random), vectorOf(1.0).normalized()))};
  };
  const std::string text = R"(
components:
  - {name: base, pose: {position: [0.1, 0, 0], rpy: [0, 20 deg, 10 deg]}}
  - {name: arm, parent: base, pose: {position: [0.1, 0.02, 0]}}
  - {name: tool, parent: arm, pose: {position: [0.05, 0, 0.01]}}
cables:
  - {name: strand, length: 400 mm, stiffness: {EA: 5 kN, GA: 2 kN, EI: 0.02, GJ: 0.016, mass_per_length: 0.1, radius: 4 mm}}
clips:
  - {name: A, type: fixed, cable: strand, at: start, pose: {position: [0, 0, 0]}}
  - {name: B, type: fixed, cable: strand, at: end, component: tool, pose: {position: [0.02, 0, 0], rpy: [5 deg, 0, 0]}}
design_variables:
  - {name: base_y, component: base, translate: y, tolerance: 5 mm}
  - {name: base_rz, component: base, rotate: z, tolerance: 5 deg}
  - {name: arm_rx, component: arm, rotate: x, tolerance: 5 deg}
  - {name: arm_z, component: arm, translate: z, tolerance: 5 mm}
  - {name: tool_ry, component: tool, rotate: y, tolerance: 5 deg}
  - {name: clip_ry, clip: B, rotate: y, tolerance: 5 deg}
)";
  for (int trial = 0; trial < 50; ++trial) {
    Design design{readSceneText(text, "arm.yaml", findTestPackage), {}};
    for (const DesignVariable& variable : design.scene.design_variables)
      setNominal(design, variable.name, share(random) * variable.upper);
    if (trial % 2 == 0) setComponentPose(design, "arm", poseOf(0.2, 1.0));
    ComponentPoses on_tf;
    if (trial % 3 == 0) on_tf["base"] = poseOf(0.3, 2.0);
    if (trial % 3 == 1) on_tf["tool"] = poseOf(0.3, 2.0);
    const ComponentPoses moved = placesOf(design, on_tf);
    const Harness harness = harnessAt(design, {}, moved);
    const std::vector<TimedPose> poses{{0.0, poseOf(0.3, 3.0)}, {2.0, poseOf(0.3, 3.0)}};

    const ComponentPath of_clip = pathOfClip(design, moved, harness, "B", poses);
    const ComponentPath of_arm = pathOfComponent(design, moved, "arm", poses);
    const auto at = [&](const ComponentPoses& places) {
      return componentPosesAt(design.scene, design.shifted, places);
    };
    const Pose tool_on_arm = at(moved).at("arm").inverse() * at(moved).at("tool");
    for (const double time : {0.0, 0.7, 2.0}) {
      const Pose wanted = of_clip.frame(time);
      const Pose clip = harnessAt(design, {}, of_clip.places(time)).clips[1].pose;
      EXPECT_LT((clip.position - wanted.position).norm(), 1e-12) << trial;
      EXPECT_LT(clip.orientation.angularDistance(wanted.orientation), 1e-7) << trial;

      const ComponentPoses with_arm = at(of_arm.places(time));
      EXPECT_LT((with_arm.at("arm").position - wanted.position).norm(), 1e-12) << trial;
      // What rides on it keeps its place.
      const Pose tool = with_arm.at("arm").inverse() * with_arm.at("tool");
      EXPECT_LT((tool.position - tool_on_arm.position).norm(), 1e-9) << trial;
      EXPECT_LT(tool.orientation.angularDistance(tool_on_arm.orientation), 1e-7) << trial;
      EXPECT_LT((with_arm.at("base").position - at(moved).at("base").position).norm(), 1e-15);
    }
  }
}

void expectRefused(const std::function<void()>& work, const std::string& words) {
  try {
    work();
    ADD_FAILURE() << "not refused: " << words;
  } catch (const std::invalid_argument& error) {
    EXPECT_NE(std::string(error.what()).find(words), std::string::npos) << error.what();
  }
}

// A holder that shakes by a millimetre: a step of 5 mm passes over most of the poses.
TEST(PathCheck, RecordedPosesThatAreNotLookedAtAreTold) {
  Design design = designOf("test/ros/data/attachments.yaml");
  Motion& motion = design.scene.motions.front();
  const Pose home = motion.samples.front().pose;
  motion.samples.clear();
  for (int i = 0; i <= 20; ++i) {
    Pose pose = home;
    pose.position.z() += i % 2 == 0 ? 0.0 : 1e-3;
    motion.samples.push_back({0.01 * i, pose});
  }
  design.scene.attachments.clear();
  const AtRest strand(std::move(design));
  const ComponentPath path = pathOfMotions(strand.design, {}, {0}, 0.0, 0.2);
  const PathCheck coarse = strand.check(path), fine = strand.check(path, 5e-4);
  ASSERT_EQ(coarse.warnings.size(), 1u);
  const std::string expected = std::to_string(coarse.samples.size()) + " of 21 recorded poses are looked at";
  EXPECT_EQ(coarse.warnings[0].substr(0, expected.size()), expected);
  EXPECT_TRUE(fine.warnings.empty()) << fine.warnings[0];
  EXPECT_GE(fine.samples.size(), 21u);
}

TEST(PathCheck, BadPathsAreRefused) {
  const AtRest strand(designOf("test/ros/data/attachments.yaml"));
  const Pose here{{0.25, 0, 0}}, there{{0.2, 0, 0}};
  const auto along = [&](const std::string& component, const std::vector<TimedPose>& poses) {
    return pathOfComponent(strand.design, {}, component, poses);
  };
  expectRefused([&] { along("nobody", {{0, here}, {1, there}}); }, "nobody");
  expectRefused([&] { along("world", {{0, here}, {1, there}}); }, "world");
  expectRefused([&] { along("holder", {{0, here}}); }, "has 1 poses, expected two");
  expectRefused([&] { along("holder", {{1, here}, {1, there}}); }, "pose 2 is at 1 s");
  expectRefused(
      [&] {
        pathOfClip(strand.design, {}, strand.harness, "A", {{0, here}, {1, there}});
      },
      "on the world");
  expectRefused([&] { strand.check(along("holder", {{0, here}, {1, there}}), 1e-6); }, "more than 20000");
  // so short a step, so far a way, that times between cannot be told from each other: it once looked for ever
  for (const double step : {1e-19, 1e-300, 5e-324}) {
    expectRefused([&] { strand.check(along("holder", {{0, here}, {1, there}}), step); }, "more than 20000");
  }
  for (const double far : {1e18, 1e300}) {
    const Pose away{{far, 0.0, 0.0}};
    expectRefused([&] { strand.check(along("holder", {{0, here}, {1, away}})); }, "more than 20000");
  }
  PathTask task;
  task.design = strand.design;
  task.solver = strand.solver;
  task.path = along("holder", {{0, here}, {1, there}});
  EXPECT_THROW(checkPath(task, strand.evaluator, [](double) { return false; }), Cancelled);
}

TEST(PathCheck, TheWayToTheStartIsAPartOfIt) {
  const AtRest strand(designOf("test/ros/data/attachments.yaml"));
  const PathCheck check = strand.check(
      pathOfComponent(strand.design, {}, "holder", {{0.0, {{0.2, 0, 0}}}, {1.0, {{0.21, 0, 0}}}}));
  ASSERT_EQ(check.warnings.size(), 1u);
  EXPECT_NE(check.warnings[0].find("50 mm"), std::string::npos) << check.warnings[0];
  EXPECT_TRUE(check.samples.front().solved);
}

}  // namespace
}  // namespace cable_variation::test
