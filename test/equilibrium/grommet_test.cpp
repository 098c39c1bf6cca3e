// A grommet is six springs: Hooke's law each, a fixed clip when stiff, nothing when soft.

#include <gtest/gtest.h>

#include <equilibrium/case_table.h>

namespace cable_variation::test {
namespace {

Cable hose() { return cableKinds()[1].cable; }

TEST(Grommet, EachSpringObeysHookesLaw) {
  // six different springs, none of which can stand in for another
  const std::array<double, 3> along{310.0, 470.0, 620.0}, about{0.11, 0.17, 0.26};
  ClipConstraint six;
  for (std::size_t k = 0; k < 3; ++k) {
    six.translation[k] = ClipFreedom::sprung(along[k]);
    six.rotation[k] = ClipFreedom::sprung(about[k]);
  }
  const Harness harness = heldBetween(hose(), six);
  const Equilibrium result = solve(harness);
  ASSERT_TRUE(result.converged()) << result.message;
  const Pose& frame = harness.clips[2].pose;
  const Reaction& reaction = result.clip_reactions[2];
  const Pose held = frame.inverse() * reaction.section;
  const Eigen::Vector3d turn = so3::log(held.orientation);
  const Eigen::Vector3d force = frame.orientation.conjugate() * reaction.force;
  // moments are conjugate to the rotation vector's components: J_rᵀ times the moment in the section frame
  const Eigen::Vector3d moment =
      so3::rightJacobian(turn).transpose() * (reaction.section.orientation.conjugate() * reaction.moment);
  double energy = 0.0;
  for (std::size_t k = 0; k < 3; ++k) {
    const auto axis = static_cast<Eigen::Index>(k);
    EXPECT_GT(std::abs(force[axis]), 0.1);
    EXPECT_GT(std::abs(moment[axis]), 1e-3);
    EXPECT_NEAR(force[axis], -along[k] * held.position[axis], 1e-8);
    EXPECT_NEAR(moment[axis], -about[k] * turn[axis], 1e-8);
    energy += 0.5 * along[k] * std::pow(held.position[axis], 2) + 0.5 * about[k] * std::pow(turn[axis], 2);
  }
  EXPECT_NEAR(result.energy.springs, energy, 1e-12);
}

TEST(Grommet, NamedStiffnessesGoToTheirAxes) {
  const ClipConstraint grommet = grommetClip({1.0, 2.0, 3.0, 4.0}, true);
  EXPECT_EQ(grommet.translation[0].stiffness, 1.0);
  EXPECT_EQ(grommet.translation[1].stiffness, 2.0);
  EXPECT_EQ(grommet.translation[2].stiffness, 2.0);
  EXPECT_EQ(grommet.rotation[0].stiffness, 3.0);
  EXPECT_EQ(grommet.rotation[1].stiffness, 4.0);
  EXPECT_EQ(grommet.rotation[2].stiffness, 4.0);
  EXPECT_TRUE(grommet.slides);
  EXPECT_FALSE(grommetClip({1.0, 2.0, 3.0, 4.0}).slides);
}

double largestDistanceBetween(const Equilibrium& a, const Equilibrium& b) {
  double largest = 0.0;
  for (int i = 0; i <= 60; ++i) {
    const double s = kTableLength * i / 60.0;
    largest = std::max(largest, (a.shapes.at(0).position(s) - b.shapes.at(0).position(s)).norm());
  }
  return largest;
}

// With springs k the fixed clip's reaction (newtons, 0.1 N m) deflects it by 1/k: 1e-8 m and 1e-7 rad.
TEST(Grommet, IsAFixedClipWhenStiff) {
  const Equilibrium fixed = solve(heldBetween(hose(), fixedClip()));
  const Equilibrium stiff = solve(heldBetween(hose(), grommetClip({1e9, 1e9, 1e6, 1e6})));
  ASSERT_TRUE(fixed.converged() && stiff.converged()) << fixed.message << stiff.message;
  EXPECT_LT(largestDistanceBetween(fixed, stiff), 1e-7);
  const Eigen::Vector3d& force = fixed.clip_reactions[2].force;
  EXPECT_LT((force - stiff.clip_reactions[2].force).norm(), 1e-5 * force.norm());
}

// Deflections of 0.1 m and 1 rad against 1e-7 N/m and N m/rad, the cable being stiffer than 1 N/m and 0.01 N
// m.
TEST(Grommet, IsNoClipWhenSoft) {
  const Equilibrium none = solve(heldBetween(hose(), freeClip()));
  const Equilibrium soft = solve(heldBetween(hose(), grommetClip({1e-7, 1e-7, 1e-7, 1e-7})));
  ASSERT_TRUE(none.converged() && soft.converged()) << none.message << soft.message;
  EXPECT_LT(largestDistanceBetween(none, soft), 1e-6);
  EXPECT_LT(soft.clip_reactions[2].force.norm(), 1e-7);
}

TEST(Grommet, SlidingOneSlidesUntilTheConfigurationalForceIsContinuous) {
  const GrommetStiffness rubber{300.0, 500.0, 0.1, 0.2};
  const Equilibrium held = solve(heldBetween(hose(), grommetClip(rubber)));
  const Equilibrium slid = solve(heldBetween(hose(), grommetClip(rubber, true)));
  ASSERT_TRUE(held.converged() && slid.converged()) << held.message << slid.message;
  EXPECT_GT(std::abs(slid.clip_reactions[2].arc_length - held.clip_reactions[2].arc_length), 1e-4);
  EXPECT_LT(slid.energy.total(), held.energy.total() - 1e-5);  // one freedom more
}

}  // namespace
}  // namespace cable_variation::test
