// Requests for a path: which places of recorded motions are looked at.
#include <ros_interface/conversion/path_request.h>

#include <algorithm>

#include <gtest/gtest.h>

#include <cable_variation/path/path_check.h>

namespace cable_variation_ros {
namespace {

using namespace cable_variation;

// An engine that shakes by a millimetre, with a cable from it to the world.
Design shakingEngine(std::size_t poses) {
  Design design;
  Scene& scene = design.scene;
  Component engine;
  engine.name = "engine";
  scene.components = {engine};
  Cable cable;
  cable.name = "hose";
  cable.length = 0.3;
  cable.sections = {{0.0, solidSection(0.004, {1e8, 0.25, 2000.0})}};
  scene.harness.cables = {cable};
  Clip end;
  end.name = "end";
  end.arc_length = cable.length;
  end.constraint = fixedClip();
  end.pose.position = {0.25, 0.0, 0.0};
  Clip start = end;
  start.name = "start";
  start.arc_length = 0.0;
  start.pose = Pose{};
  scene.harness.clips = {start, end};
  scene.clip_mounts = {{"world", start.pose}, {"engine", end.pose}};
  Motion motion;
  motion.name = "run";
  motion.component = "engine";
  for (std::size_t i = 0; i < poses; ++i) {
    Pose pose;
    pose.position.z() = i % 2 == 0 ? 0.0 : 1e-3;
    motion.samples.push_back({0.01 * static_cast<double>(i), pose});
  }
  scene.motions = {motion};
  return design;
}

ComponentPath pathOf(const Design& design, double step) {
  CheckPathRequest request;
  request.motions = {"run"};
  request.step = step;
  return toPath(request, design, harnessAt(design, {}), {}, {}).path;
}

TEST(PathRequest, EveryRecordedPoseIsLookedAtUnlessAStepIsAskedFor) {
  const Design design = shakingEngine(41);
  EXPECT_TRUE(pathOf(design, 0.0).every_pose);
  EXPECT_FALSE(pathOf(design, 5e-3).every_pose);

  EquilibriumSolver solver;
  const Harness harness = harnessAt(design, {});
  const Equilibrium equilibrium = solver.solve(harness);
  ASSERT_TRUE(equilibrium.converged());
  const ComponentPoses components = componentPosesAt(design.scene, design.shifted);
  const MeasureEvaluator evaluator(design.scene, {harness, equilibrium, components});
  PathTask task;
  task.design = design;
  task.solver = solver;
  task.path = pathOf(design, 0.0);
  const PathCheck check = checkPath(task, evaluator);
  EXPECT_TRUE(check.warnings.empty()) << check.warnings.front();
  for (const TimedPose& pose : design.scene.motions[0].samples) {
    EXPECT_TRUE(std::any_of(check.samples.begin(), check.samples.end(), [&](const PathSample& sample) {
      return sample.time == pose.time;
    })) << pose.time;
  }
}

// More than anybody waits for: steps, and a warning by checkPath().
TEST(PathRequest, OfVeryManyPosesStepsAreLookedAt) {
  EXPECT_FALSE(pathOf(shakingEngine(15'001), 0.0).every_pose);
}

}  // namespace
}  // namespace cable_variation_ros
