// Branches: what each joint keeps together and which moments it transmits.

#include <gtest/gtest.h>

#include <equilibrium/case_table.h>

namespace cable_variation::test {
namespace {

// Balance of the branch alone: the joint carries its weight and its load.
void expectCarriesTheBranch(const Harness& harness, const Equilibrium& result) {
  const Reaction& joint = result.joint_reactions.at(0);
  const Cable& branch = harness.cables[1];
  const CableShape& shape = result.shapes[1];
  const Eigen::Vector3d weight_per_length = branch.sections[0].section.mass_per_length * harness.gravity;
  Eigen::Vector3d force = joint.force, moment = joint.section.position.cross(joint.force) + joint.moment;
  constexpr int kPieces = 300;
  for (int i = 0; i < kPieces; ++i) {  // the midpoint rule leaves (1/300)²/24 of a moment of 0.02 N m: 1e-8
    const Eigen::Vector3d weight = branch.length / kPieces * weight_per_length;
    force += weight;
    moment += shape.position((i + 0.5) * branch.length / kPieces).cross(weight);
  }
  const PointLoad& load = harness.loads.back();
  force += load.force;
  moment += shape.position(load.arc_length).cross(load.force);
  EXPECT_LT(force.norm(), 1e-8);
  EXPECT_LT(moment.norm(), 3e-8);
}

class Branch : public testing::TestWithParam<Joint::Type> {};

TEST_P(Branch, SitsOnItsParentAndLoadsIt) {
  const Harness harness = branched(GetParam());
  const Equilibrium result = solve(harness, 1e-8);
  ASSERT_TRUE(result.converged()) << result.message;
  const Joint& joint = harness.joints[0];
  const Pose parent = result.shapes[0].pose(joint.parent_arc_length);
  const Pose child = result.shapes[1].pose(joint.child_arc_length);
  EXPECT_LT((parent.position - child.position).norm(), 1e-12);
  expectCarriesTheBranch(harness, result);

  const Reaction& reaction = result.joint_reactions[0];
  const Eigen::Vector3d moment = child.orientation.conjugate() * reaction.moment;  // in the child's section
  const Eigen::Vector3d turn =
      so3::log(joint.rotation.conjugate() * parent.orientation.conjugate() * child.orientation);
  const Eigen::Vector3d across = joint.axis.unitOrthogonal();
  switch (GetParam()) {
    case Joint::Type::fixed:
      EXPECT_LT(turn.norm(), 1e-12);
      for (int k = 0; k < 3; ++k) EXPECT_GT(std::abs(moment[k]), 1e-3);
      break;
    case Joint::Type::pivot:
      EXPECT_GT(turn.norm(), 0.1);
      EXPECT_LT(moment.norm(), 1e-8);
      break;
    case Joint::Type::hinge:
      EXPECT_GT(std::abs(turn.dot(joint.axis)), 0.1);
      EXPECT_LT(turn.cross(joint.axis).norm(), 1e-12);
      EXPECT_LT(std::abs(moment.dot(joint.axis)), 1e-8);
      EXPECT_GT(std::abs(moment.dot(across)), 1e-3);
      EXPECT_GT(std::abs(moment.dot(joint.axis.cross(across))), 1e-3);
      break;
  }
  // the trunk's section force jumps by what the joint hands on
  const auto& points = result.shapes[0].points;
  for (std::size_t i = 0; i + 1 < points.size(); ++i) {
    if (points[i].arc_length != points[i + 1].arc_length) continue;
    if (std::abs(points[i].arc_length - joint.parent_arc_length) > 1e-9) continue;
    EXPECT_LT((points[i].force - points[i + 1].force + reaction.force).norm(), 1e-8);
    EXPECT_LT((points[i].moment - points[i + 1].moment + reaction.moment).norm(), 1e-8);
    return;
  }
  FAIL() << "no step of the trunk's section force at the joint";
}

INSTANTIATE_TEST_SUITE_P(Types, Branch,
                         testing::Values(Joint::Type::fixed, Joint::Type::pivot, Joint::Type::hinge));

TEST(ClosedLoop, BothEndsStayOnTheTrunk) {
  const Harness harness = closedLoop();
  const Equilibrium result = solve(harness, 1e-7);
  ASSERT_TRUE(result.converged()) << result.message;
  for (const Joint& joint : harness.joints) {
    const Pose parent = result.shapes[0].pose(joint.parent_arc_length);
    const Pose child = result.shapes[1].pose(joint.child_arc_length);
    EXPECT_LT((parent.position - child.position).norm(), 1e-12) << joint.name;
    const Eigen::Quaterniond apart = (parent.orientation * joint.rotation).conjugate() * child.orientation;
    const Eigen::Vector3d turn = so3::log(apart);
    if (joint.type == Joint::Type::fixed) {
      EXPECT_LT(turn.norm(), 1e-12);
    } else {
      EXPECT_LT(turn.cross(joint.axis).norm(), 1e-12);
    }
  }
  // both joints together carry the loop's weight
  const double weight =
      9.81 * harness.cables[1].sections[0].section.mass_per_length * harness.cables[1].length;
  const Eigen::Vector3d carried = result.joint_reactions[0].force + result.joint_reactions[1].force;
  EXPECT_LT((carried - Eigen::Vector3d(0.0, 0.0, weight)).norm(), 1e-8);
  EXPECT_GT(result.joint_reactions[0].force.norm(), 2.0 * weight);  // the loop is bent, not just hung
}

// A joint in the middle of the child instead of at its end, and a child that a clip holds as well.
TEST(Branch, MayBeJoinedAnywhereAndBeClippedToo) {
  Harness harness = branched(Joint::Type::fixed);
  harness.joints[0].child_arc_length = 0.05;
  const Equilibrium open = solve(harness, 1e-7);
  ASSERT_TRUE(open.converged()) << open.message;
  const Pose tip = open.shapes[1].points.back().pose;
  harness.clips.push_back(clipOn(1, "end", 0.12, pivotClip(), {tip.position, tip.orientation}));
  const Equilibrium held = solve(harness, 1e-7);
  ASSERT_TRUE(held.converged()) << held.message;
  // held where it hangs anyway, the clip has nothing to do
  EXPECT_LT(held.clip_reactions[3].force.norm(), 1e-4);
  EXPECT_LT(
      (held.shapes[1].points.front().pose.position - open.shapes[1].points.front().pose.position).norm(),
      1e-6);
}

}  // namespace
}  // namespace cable_variation::test
