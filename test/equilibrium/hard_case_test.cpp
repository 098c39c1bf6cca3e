// Shapes that a solver easily misses: turned ends, twist, slack, buckling,
// neutral motions, and clips that no cable can join.

#include <cstring>

#include <gtest/gtest.h>

#include <cable_variation/equilibrium/neutral_note.h>
#include <equilibrium/cases.h>

namespace cable_variation::test {
namespace {

const Eigen::Vector3d kWeightless = Eigen::Vector3d::Zero();
constexpr double kLength = 0.312;

Cable strand() { return uniformCable(kLength, strandOfCaseW(), "strand"); }

struct EndPose {
  const char* name;
  Pose pose;
};

std::ostream& operator<<(std::ostream& out, const EndPose& end) { return out << end.name; }

class TurnedEnd : public testing::TestWithParam<EndPose> {};

TEST_P(TurnedEnd, SettlesInAStableShape) {
  const Equilibrium result = solve(clamped(strand(), GetParam().pose), 1e-5);
  ASSERT_TRUE(result.converged()) << result.message;
  EXPECT_GT(result.smallest_eigenvalue, 0.0);
  const ShapePoint& end = result.shapes[0].points.back();
  EXPECT_LT((end.pose.position - GetParam().pose.position).norm(), 1e-12);
  EXPECT_LT(angleBetween(end.pose.orientation, GetParam().pose.orientation), 1e-12);
  for (const ShapePoint& point : result.shapes[0].points) EXPECT_LT(point.strain.norm(), 0.1);
}

INSTANTIATE_TEST_SUITE_P(
    Poses, TurnedEnd,
    testing::Values(EndPose{"half_turn_about_z", poseAt(0.05, 0.12, 0.0, {0.0, 0.0, M_PI})},
                    EndPose{"half_turn_about_y", poseAt(0.02, 0.0, -0.10, {0.0, M_PI, 0.0})},
                    EndPose{"half_turn_facing", poseAt(0.20, 0.0, 0.0, {0.0, 0.0, M_PI})},
                    EndPose{"more_than_half", poseAt(0.05, 0.08, 0.03, {0.0, 0.0, 4.0})},
                    EndPose{"rolled_half", poseAt(0.25, 0.0, 0.0, {M_PI, 0.0, 0.0})},
                    EndPose{"back_beside_the_start", poseAt(0.0, 0.03, 0.0, {0.0, 0.0, M_PI})},
                    EndPose{"on_the_start", poseAt(0.0, 0.0, 0.0)}),
    [](const auto& of) { return of.param.name; });

// Drawn tight, three turns leave the rod straight: twist GJ ψ/L is 63 % of the critical moment.
TEST(Twist, SeveralTurnsAreWoundInWhenHinted) {
  const Section section = roundSection(1e4, 5e3, 0.3, 1.0);
  Cable cable = uniformCable(1.0, section);
  const double turns = 6.0 * M_PI;
  for (double sign : {1.0, -1.0}) {
    cable.twist = sign * turns;
    const Equilibrium result = solve(clamped(cable, poseAt(1.001, 0.0, 0.0), kWeightless));
    ASSERT_TRUE(result.converged()) << result.message;
    EXPECT_GT(result.smallest_eigenvalue, 0.0);
    // elements of a quarter turn each
    EXPECT_NEAR(result.clip_reactions[1].moment.x(), sign * 0.3 * turns, 1e-4);
    EXPECT_NEAR(result.energy.elastic, 0.5 * 0.3 * turns * turns + 0.5 * 1e4 * 1e-6, 1e-3);
  }
  cable.twist.reset();
  const Equilibrium least = solve(clamped(cable, poseAt(1.001, 0.0, 0.0), kWeightless));
  EXPECT_NEAR(least.energy.elastic, 0.5 * 1e4 * 1e-6, 1e-8);  // no twist but what the clips ask for
}

TEST(Twist, SlackCableOfSeveralTurnsIsStable) {
  Cable cable = strand();
  for (double turns : {1.0, -2.0, 3.0}) {
    cable.twist = 2.0 * M_PI * turns;
    const Equilibrium result = solve(clamped(cable, poseAt(0.28, 0.03, 0.0)), 1e-5);
    ASSERT_TRUE(result.converged()) << turns << " turns: " << result.message;
    EXPECT_GT(result.smallest_eigenvalue, 0.0) << turns << " turns";
  }
}

TEST(SlackCable, FortyPercentLongerThanItsSpanHangsInItsPlane) {
  const Equilibrium result = solve(clamped(strand(), poseAt(kLength / 1.4, 0.0, 0.0)), 1e-5);
  ASSERT_TRUE(result.converged()) << result.message;
  EXPECT_GT(result.smallest_eigenvalue, 0.0);
  // the lowest shape sags: a stiff strand between clamps could also arch, at the price of weight
  EXPECT_LT(result.shapes[0].position(0.5 * kLength).z(), -0.05);
}

// Stiff sideways, a slack strip can stay above its clamps as well as below: the other shape is reported.
TEST(SlackStrip, SagsAndReportsTheArch) {
  Cable strip = strand();
  strip.sections[0].section.EI_z *= 10.0;
  const Pose end = poseAt(kLength / 1.4, 0.0, 0.0);
  const Equilibrium sag = solve(clamped(strip, end), 1e-5);
  ASSERT_TRUE(sag.converged()) << sag.message;
  EXPECT_LT(sag.shapes[0].position(0.5 * kLength).z(), -0.05);
  strip.via = {{0.11, 0.0, 0.09}};
  const Equilibrium arch = solve(clamped(strip, end), 1e-5);
  ASSERT_TRUE(arch.converged()) << arch.message;
  EXPECT_GT(arch.shapes[0].position(0.5 * kLength).z(), 0.05);
  ASSERT_FALSE(sag.alternatives.empty());
  // alternatives are judged on the grid the search starts with
  EXPECT_NEAR(sag.alternatives[0].energy, arch.energy.total(), 1e-3 * arch.energy.total());
  const double apart =
      (sag.shapes[0].position(0.5 * kLength) - arch.shapes[0].position(0.5 * kLength)).norm();
  EXPECT_NEAR(sag.alternatives[0].largest_distance, apart, 0.05 * apart);
}

TEST(HangingCable, HangsStraightDownFromAPivot) {
  Harness harness = cantilever(strand());
  harness.clips[0].constraint = pivotClip();
  const Equilibrium result = solve(harness);
  ASSERT_TRUE(result.converged()) << result.message;
  const double weight = 9.81 * strandOfCaseW().mass_per_length * kLength;
  EXPECT_LT((result.clip_reactions[0].force - Eigen::Vector3d(0.0, 0.0, weight)).norm(), 1e-9);
  EXPECT_LT(result.clip_reactions[0].moment.norm(), 1e-9);
  // stretched by its own weight: ρA g L²/2EA
  const Eigen::Vector3d tip = result.shapes[0].points.back().pose.position;
  EXPECT_LT(tip.head<2>().norm(), 1e-6);
  EXPECT_NEAR(tip.z(), -kLength - 0.5 * weight * kLength / strandOfCaseW().EA, 1e-9);
}

// A clamped column buckles at 4 π² EI/L²; pressed to twice that strain it must bow out. The strains of a
// slender rod: 8 π² EI/(EA L²) is 0.32 % here.
Harness pressedColumn(const Section& section) {
  const double strain =
      8.0 * M_PI * M_PI * std::min(section.EI_y, section.EI_z) / (section.EA * kLength * kLength);
  return clamped(uniformCable(kLength, section), poseAt(kLength * (1.0 - strain), 0.0, 0.0), kWeightless);
}

TEST(PressedColumn, BowsOutAboutItsSoftAxis) {
  Section flat = strandOfCaseW();
  flat.EI_z *= 2.0;
  const Equilibrium result = solve(pressedColumn(flat));
  ASSERT_TRUE(result.converged()) << result.message;
  EXPECT_GT(result.smallest_eigenvalue, 0.0);
  const Eigen::Vector3d middle = result.shapes[0].position(0.5 * kLength);
  EXPECT_GT(std::abs(middle.z()), 0.005);
  EXPECT_LT(std::abs(middle.y()), 1e-6);
  // near the bifurcation the bowed column carries the critical load, a little more
  const double critical = 4.0 * M_PI * M_PI * flat.EI_y / (kLength * kLength);
  EXPECT_NEAR(-result.clip_reactions[1].force.x() / critical, 1.0, 0.02);
}

TEST(PressedColumn, RoundOneBowsOutSomewhereAndIsNotCalledUnstable) {
  const Equilibrium result = solve(pressedColumn(strandOfCaseW()));
  ASSERT_TRUE(result.converged()) << result.message;
  EXPECT_GT(result.shapes[0].position(0.5 * kLength).tail<2>().norm(), 0.005);
}

// Ball joints leave a round cable free to roll: a motion without energy is no instability.
TEST(TwoPivots, NeutralRollPassesAsStable) {
  Harness harness = clamped(strand(), poseAt(0.25, 0.05, 0.0));
  for (Clip& clip : harness.clips) clip.constraint = pivotClip();
  const Equilibrium result = solve(harness);
  ASSERT_TRUE(result.converged()) << result.message;
  EXPECT_NE(neutralNote(result).find("'strand' is free to turn about its own axis"), std::string::npos);
  EXPECT_GT(result.smallest_eigenvalue, 1.0);  // the swing under its weight
}

// A cable that slides out of what should hold it is no matter of too few steps.
TEST(NotHeld, CablesThatOnlySlideOrGoOnAreNamedWithTheirClips) {
  Harness harness = clamped(strand(), poseAt(0.2, 0.0, -0.1));
  for (Clip& clip : harness.clips) clip.constraint = slidingRollingClip();
  harness.clips[0].arc_length = 0.02;
  harness.clips[1].arc_length = 0.25;
  const Equilibrium lost = solve(harness);
  ASSERT_EQ(lost.status, EquilibriumStatus::not_converged);
  EXPECT_NE(lost.message.find("nothing holds 'strand' along its way: 'A' (slides), 'B' (slides)"),
            std::string::npos)
      << lost.message;
  harness.clips[0].constraint = fixedClip();
  harness.clips[0].arc_length = 0.0;
  EXPECT_TRUE(solve(harness).converged());
}

TEST(Impossible, ClipsFurtherApartThanTheCableAreNamed) {
  Harness harness = clamped(strand(), poseAt(0.35, 0.0, 0.0));
  const Equilibrium ends = solve(harness);
  EXPECT_EQ(ends.status, EquilibriumStatus::impossible);
  EXPECT_NE(ends.message.find("'A' and 'B'"), std::string::npos) << ends.message;
  EXPECT_NE(ends.message.find("'strand'"), std::string::npos) << ends.message;
  EXPECT_TRUE(ends.shapes.empty());

  harness.clips[1].pose = poseAt(0.2, 0.0, 0.0);
  harness.clips.push_back(clipOn(0, "C", 0.1, rollingClip(), poseAt(0.05, 0.15, 0.0)));
  const Equilibrium between = solve(harness);
  EXPECT_EQ(between.status, EquilibriumStatus::impossible);
  EXPECT_NE(between.message.find("'A' and 'C'"), std::string::npos) << between.message;
}

// The detour through a clip that slides counts as well.
TEST(Impossible, DetourThroughAnEyeletIsNamed) {
  Harness harness = clamped(strand(), poseAt(0.2, 0.0, 0.0));
  harness.clips.push_back(clipOn(0, "ring", 0.15, eyeletClip(), poseAt(0.1, 0.2, 0.0)));
  const Equilibrium result = solve(harness);
  EXPECT_EQ(result.status, EquilibriumStatus::impossible) << toString(result.status);
}

TEST(Solve, IsDeterministicToTheLastBit) {
  const Equilibrium once = solve(caseW()), again = solve(caseW());
  ASSERT_EQ(once.shapes[0].points.size(), again.shapes[0].points.size());
  for (std::size_t i = 0; i < once.shapes[0].points.size(); ++i) {
    const Pose& a = once.shapes[0].points[i].pose;
    const Pose& b = again.shapes[0].points[i].pose;
    EXPECT_EQ(std::memcmp(a.position.data(), b.position.data(), 3 * sizeof(double)), 0);
    EXPECT_EQ(std::memcmp(a.orientation.coeffs().data(), b.orientation.coeffs().data(), 4 * sizeof(double)),
              0);
  }
  EXPECT_EQ(once.iterations, again.iterations);
  EXPECT_EQ(once.smallest_eigenvalue, again.smallest_eigenvalue);
}

// A slack cable without weight may bow to either side; `via` says which.
TEST(Via, PicksTheSide) {
  Cable cable = strand();
  for (double side : {1.0, -1.0}) {
    cable.via = {{0.11, side * 0.09, 0.0}};
    const Equilibrium result = solve(clamped(cable, poseAt(0.22, 0.0, 0.0), kWeightless), 1e-5);
    ASSERT_TRUE(result.converged()) << result.message;
    EXPECT_GT(side * result.shapes[0].position(0.5 * kLength).y(), 0.02);
  }
}

}  // namespace
}  // namespace cable_variation::test
