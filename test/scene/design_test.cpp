// Edits of a scene: what they change, what they leave, what they refuse.
#include <cable_variation/scene/design.h>

#include <cmath>
#include <random>
#include <stdexcept>

#include <gtest/gtest.h>

#include <cable_variation/scene/moving_components.h>

namespace cable_variation {
namespace {

/// A cable between the world and a holder at x = 0.25 m that is turned by 90° about z.
Design strand() {
  const Material material{1e8, 0.25, 2000};
  Scene scene;
  Component holder;
  holder.name = "holder";
  holder.pose = {{0.25, 0.0, 0.0}, Eigen::Quaterniond(Eigen::AngleAxisd(M_PI / 2, Eigen::Vector3d::UnitZ()))};
  scene.components = {holder};
  Cable cable;
  cable.name = "strand";
  cable.length = 0.312;
  cable.sections = {{0.0, solidSection(0.004, material)}};
  scene.harness.cables = {cable};
  Clip clip;
  clip.name = "A";
  clip.type = "fixed";
  clip.constraint = fixedClip();
  scene.harness.clips.push_back(clip);
  clip.name = "B";
  clip.arc_length = 0.3;
  clip.pose = holder.pose;
  scene.harness.clips.push_back(clip);
  scene.clip_mounts = {{"world", Pose()}, {"holder", Pose()}};
  DesignVariable length;
  length.name = "length";
  length.target = CableProperty{0, CableProperty::Property::length};
  length.nominal = 0.312;
  DesignVariable shift;
  shift.name = "b_x";
  shift.target = ClipTranslation{1, Axis::x};
  scene.design_variables = {length, shift};
  return {scene, {}};
}

Eigen::Vector3d positionOfB(const Design& design, const DesignValues& values = {}) {
  return harnessAt(design, values).clips[1].pose.position;
}

TEST(Design, ANominalDeviationHoldsUntilAValueOverridesIt) {
  Design design = strand();
  setNominal(design, "b_x", 0.01);
  EXPECT_EQ(design.scene.design_variables[1].nominal, 0.01);
  // x of the clip is y of the world.
  EXPECT_TRUE(positionOfB(design).isApprox(Eigen::Vector3d(0.25, 0.01, 0.0), 1e-12));
  EXPECT_TRUE(positionOfB(design, {{"b_x", -0.02}}).isApprox(Eigen::Vector3d(0.25, -0.02, 0.0), 1e-12));
}

TEST(Design, ANominalQuantityAndTheEditOfItAreOne) {
  Design design = strand();
  setNominal(design, "length", 0.32);
  EXPECT_EQ(harnessAt(design, {}).cables[0].length, 0.32);
  setCableLength(design, "strand", 0.33);
  EXPECT_EQ(harnessAt(design, {}).cables[0].length, 0.33);
  EXPECT_EQ(design.scene.design_variables[0].nominal, 0.33);
  EXPECT_EQ(harnessAt(design, {{"length", 0.34}}).cables[0].length, 0.34);
}

TEST(Design, ClipsMoveInTheirOwnAxesAndTheirComponents) {
  Design design = strand();
  moveClip(design, "B", {0.01, 0.0, 0.0}, {0.0, 0.0, M_PI / 2});
  EXPECT_TRUE(positionOfB(design).isApprox(Eigen::Vector3d(0.25, 0.01, 0.0), 1e-12));
  // Its x axis now looks back along the world's.
  moveClip(design, "B", {0.05, 0.0, 0.0}, Eigen::Vector3d::Zero());
  EXPECT_TRUE(positionOfB(design).isApprox(Eigen::Vector3d(0.20, 0.01, 0.0), 1e-12));
  setClipPose(design, "B", {{0.0, 0.0, 0.03}, Eigen::Quaterniond::Identity()});
  EXPECT_TRUE(positionOfB(design).isApprox(Eigen::Vector3d(0.25, 0.0, 0.03), 1e-12));
}

TEST(Design, AClipMovesAlongItsCable) {
  Design design = strand();
  setClipArcLength(design, "B", 0.29);
  EXPECT_EQ(harnessAt(design, {}).clips[1].arc_length, 0.29);
}

// A new length that clips scale with moves a clip; the variable of its place has its nominal there.
TEST(Design, WhatFollowsFromAnEditIsNominalToo) {
  Design design = strand();
  std::get<CableProperty>(design.scene.design_variables[0].target).clips_scale = true;
  DesignVariable place;
  place.name = "b_at";
  place.target = ClipArcLength{1};
  place.nominal = 0.3;
  design.scene.design_variables.push_back(place);
  setCableLength(design, "strand", 0.156);
  EXPECT_DOUBLE_EQ(design.scene.design_variables[2].nominal, 0.15);
  EXPECT_DOUBLE_EQ(harnessAt(design, {{"b_at", 0.15}}).clips[1].arc_length, 0.15);
}

// A factor is relative to the nominal one: setting it again does not apply it twice.
TEST(Design, ARestCurvatureIsSetOnce) {
  Design design = strand();
  design.scene.harness.cables[0].rest_curvature = {{0.0, {0.0, 0.0, 2.0}}};
  DesignVariable shape;
  shape.name = "shape";
  shape.target = CableProperty{0, CableProperty::Property::rest_curvature};
  shape.nominal = 1.0;
  design.scene.design_variables.push_back(shape);
  setNominal(design, "shape", 1.1);
  setNominal(design, "shape", 1.1);
  EXPECT_DOUBLE_EQ(design.scene.harness.cables[0].rest_curvature[0].curvature.z(), 2.2);
}

/// A component that is moved by hand is elsewhere over a motion too, and so is what rides on it.
TEST(Design, ShiftsInTheSceneAreTheSameAtRestAndOverAMotion) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> share(-1.0, 1.0);
  const auto poseOf = [&](double size) {
    const Eigen::Vector3d place(share(random), share(random), share(random)),
        axis(share(random), share(random), share(random));
    return Pose{size * place, Eigen::Quaterniond(Eigen::AngleAxisd(2.0 * share(random), axis.normalized()))};
  };
  for (int trial = 0; trial < 40; ++trial) {
    Design design = strand();
    Component tool;
    tool.name = "tool";
    tool.parent = "holder";
    tool.pose = poseOf(0.1);
    design.scene.components.push_back(tool);
    design.scene.clip_mounts[1].component = "tool";
    Motion motion;
    motion.component = trial % 2 == 0 ? "holder" : "tool";
    motion.samples = {{0.0, poseOf(0.2)}, {1.0, poseOf(0.2)}};
    design.scene.motions = {motion};
    if (trial % 3 != 0) setComponentPose(design, "holder", poseOf(0.3));
    if (trial % 3 != 1) setComponentPose(design, "tool", poseOf(0.3));
    setNominal(design, "b_x", 0.01 * share(random));

    const Design other = withShiftsInScene(design);
    EXPECT_TRUE(other.shifts.empty());
    const auto expectSame = [&](const ComponentPoses& moved, const ComponentPoses& moved_other) {
      const Pose a = harnessAt(design, {}, placesOf(design, moved)).clips[1].pose;
      const Pose b = harnessAt(other, {}, moved_other).clips[1].pose;
      EXPECT_LT((a.position - b.position).norm(), 1e-12) << trial;
      EXPECT_LT(a.orientation.angularDistance(b.orientation), 1e-7) << trial;
    };
    expectSame({}, {});
    for (const double time : {0.0, 1.0}) {
      expectSame(posesDuring(design.scene, {&design.scene.motions[0]}, time),
                 posesDuring(other.scene, {&other.scene.motions[0]}, time));
    }
  }
}

TEST(Design, RefusedEditsChangeNothing) {
  Design design = strand();
  const double nan = std::nan("");
  EXPECT_THROW(setNominal(design, "c_x", 0.0), std::invalid_argument);
  EXPECT_THROW(setNominal(design, "b_x", nan), std::invalid_argument);
  EXPECT_THROW(setNominal(design, "length", -1.0), std::invalid_argument);
  EXPECT_THROW(setCableLength(design, "rope", 0.3), std::invalid_argument);
  EXPECT_THROW(setCableLength(design, "strand", 0.0), std::invalid_argument);
  EXPECT_THROW(setCableLength(design, "strand", 0.1), std::invalid_argument) << "clip B is at 0.3 m";
  EXPECT_THROW(setClipArcLength(design, "B", 0.4), std::invalid_argument);
  EXPECT_THROW(setClipPose(design, "Q", Pose()), std::invalid_argument);
  EXPECT_THROW(setClipPose(design, "B", {{nan, 0.0, 0.0}, Eigen::Quaterniond::Identity()}),
               std::invalid_argument);
  EXPECT_THROW(setClipPose(design, "B", {{0.0, 0.0, 0.0}, Eigen::Quaterniond(2, 0, 0, 0)}),
               std::invalid_argument);
  EXPECT_THROW(moveClip(design, "B", {0.0, 0.0, 0.0}, {0.0, nan, 0.0}), std::invalid_argument);
  EXPECT_EQ(harnessAt(design, {}).cables[0].length, 0.312);
  EXPECT_EQ(harnessAt(design, {}).clips[1].arc_length, 0.3);
  EXPECT_TRUE(positionOfB(design).isApprox(Eigen::Vector3d(0.25, 0.0, 0.0), 1e-12));
}

}  // namespace
}  // namespace cable_variation
