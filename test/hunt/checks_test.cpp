// The checks find what is wrong: true answers pass, each kind of falsified one does not.

#include <gtest/gtest.h>

#include <equilibrium/cases.h>
#include <hunt/balance_check.h>
#include <hunt/judge.h>
#include <hunt/rod_integration.h>
#include <hunt/rotation.h>

namespace cable_variation::hunt {
namespace {

using Eigen::Vector3d;

// Clamp, sliding clip, grommet, and a branch with a hinge.
Harness richHarness() {
  Harness harness = test::clamped(test::uniformCable(0.4, test::strandOfCaseW(), "main"),
                                  test::poseAt(0.3, 0.05, 0.02, {0.2, 0.1, 0.4}));
  harness.clips.push_back(
      test::clipOn(0, "ring", 0.15, slidingRollingClip(), test::poseAt(0.12, 0.03, 0.0, {0.0, 0.1, 0.2})));
  harness.cables.push_back(test::uniformCable(0.2, test::strandOfCaseW(), "branch"));
  Joint joint;
  joint.name = "hinge";
  joint.type = Joint::Type::hinge;
  joint.parent_arc_length = 0.28;
  joint.child = 1;
  joint.rotation = rotationBy({0.0, 0.0, 0.8});
  harness.joints = {joint};
  harness.clips.push_back(test::clipOn(1, "rubber", 0.2, grommetClip({900.0, 300.0, 0.05, 0.08}),
                                       test::poseAt(0.36, 0.16, 0.05, {0.5, 0.2, 0.9})));
  return harness;
}

class Checks : public ::testing::Test {
 protected:
  void SetUp() override {
    answer = test::solve(harness, 1e-5);
    ASSERT_TRUE(answer.converged()) << answer.message;
  }
  Harness harness = richHarness();
  Equilibrium answer;
};

TEST_F(Checks, PassATrueAnswer) {
  EXPECT_LE(checkEquations(harness, answer, 1e-5).times, 1.0) << checkEquations(harness, answer, 1e-5).what;
  EXPECT_LE(checkBalance(harness, answer).times, 1.0) << checkBalance(harness, answer).what;
  EXPECT_LE(checkHolds(harness, answer).times, 1.0) << checkHolds(harness, answer).what;
  const Judgement judgement = judge(harness, {});
  EXPECT_EQ(judgement.verdict, Verdict::right) << judgement.text;
  EXPECT_FALSE(judgement.undecided) << judgement.text;
}

TEST_F(Checks, SeeAForceThatDoesNotBalance) {
  answer.clip_reactions[0].force *= 1.001;
  EXPECT_GT(checkBalance(harness, answer).times, 1.0);
}

TEST_F(Checks, SeeABranchThatDoesNotPullItsParent) {
  answer.joint_reactions[0].force.setZero();
  EXPECT_GT(checkBalance(harness, answer).times, 1.0);
}

TEST_F(Checks, SeeASpringOfAnotherStiffness) {
  harness.clips[3].constraint.rotation[1].stiffness *= 1.01;
  EXPECT_GT(checkHolds(harness, answer).times, 1.0);
}

TEST_F(Checks, SeeASlidingClipThatDidNotSlide) {
  Harness held = harness;
  held.clips[2].constraint.slides = false;
  const Equilibrium not_slid = test::solve(held, 1e-5);
  ASSERT_TRUE(not_slid.converged());
  EXPECT_LE(checkHolds(held, not_slid).times, 1.0) << checkHolds(held, not_slid).what;
  EXPECT_GT(checkHolds(harness, not_slid).times, 1.0);
}

TEST_F(Checks, SeeACableOfAnotherStiffness) {
  harness.cables[1].sections[0].section.EI_y *= 1.2;
  harness.cables[1].sections[0].section.EI_z *= 1.2;
  EXPECT_GT(checkEquations(harness, answer, 1e-5).times, 1.0);
}

TEST_F(Checks, SeeAnotherWeight) {
  harness.gravity *= 1.05;
  EXPECT_GT(checkEquations(harness, answer, 1e-5).times, 1.0);
  EXPECT_GT(checkBalance(harness, answer).times, 1.0);
}

// A quarter of a circle by an end moment, from the closed form.
TEST(RodIntegration, FollowsACircle) {
  const double length = 0.4, EI = 0.02, moment = EI * 0.5 * M_PI / length;
  const Cable cable = test::uniformCable(length, test::roundSection(1e4, 4e3, 0.015, EI));
  RodState from;
  from.moment = {0.0, 0.0, moment};
  const RodState end = integrateRod(RodProfile(cable), Vector3d::Zero(), from, 0.0, length);
  const double radius = length / (0.5 * M_PI);
  EXPECT_LT((end.position - Vector3d(radius, radius, 0.0)).norm(), 1e-10);
  EXPECT_LT((rotationVector(end.orientation) - Vector3d(0.0, 0.0, 0.5 * M_PI)).norm(), 1e-10);
}

// A hanging straight cable: its pull is the weight below, its stretch the integral of it.
TEST(RodIntegration, StretchesByItsWeight) {
  const double length = 0.5, weight = 0.3 * 9.81, EA = 500.0;
  const Cable cable = test::uniformCable(length, test::roundSection(EA, 200.0, 0.015, 0.02, 0.3));
  RodState from;
  from.force = {weight * length, 0.0, 0.0};
  const RodState end = integrateRod(RodProfile(cable), {9.81, 0.0, 0.0}, from, 0.0, length);
  EXPECT_NEAR(end.position.x(), length + 0.5 * weight * length * length / EA, 1e-11);
  EXPECT_LT(end.force.norm(), 1e-9);
}

}  // namespace
}  // namespace cable_variation::hunt
