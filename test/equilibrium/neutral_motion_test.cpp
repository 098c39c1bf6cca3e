// Motions that cost no energy: that they are told, and left out of the smallest eigenvalue, which then is
// that of closed forms; and that nothing is told where something holds them.

#include <cable_variation/equilibrium/neutral_note.h>

#include <cmath>
#include <random>
#include <string>

#include <gtest/gtest.h>

#include <equilibrium/cases.h>

namespace cable_variation::test {
namespace {

using Eigen::Vector3d;

const Vector3d kWeightless = Vector3d::Zero();
const Vector3d kGravity(0.0, 0.0, -9.81);
constexpr double kLength = 0.8, kEI = 0.05, kGJ = 0.04;

Section sectionOf(double slenderness, double mass_per_length = 0.0) {
  const double EA = slenderness * kEI / (kLength * kLength);
  return roundSection(EA, 0.4 * EA, kGJ, kEI, mass_per_length);
}

Cable rod(double mass_per_length = 0.0) { return uniformCable(kLength, sectionOf(1e7, mass_per_length)); }

Harness heldBy(Harness harness, const ClipConstraint& constraint) {
  for (Clip& clip : harness.clips) clip.constraint = constraint;
  return harness;
}

bool tells(const Equilibrium& result, const std::string& part) {
  return neutralNote(result).find(part) != std::string::npos;
}

// The note is there, whatever grid the accuracy leads to, and so is the eigenvalue, to 1e-3.
void expectNeutral(const Harness& harness, const std::string& part) {
  const Equilibrium fine = solve(harness, 1e-6), coarse = solve(harness, 1e-4);
  ASSERT_TRUE(fine.converged()) << fine.message;
  ASSERT_TRUE(coarse.converged()) << coarse.message;
  EXPECT_TRUE(tells(fine, part)) << neutralNote(fine);
  EXPECT_TRUE(tells(coarse, part)) << neutralNote(coarse);
  EXPECT_GT(fine.smallest_eigenvalue, 1e-3 * kEI / std::pow(kLength, 3));
  EXPECT_NEAR(coarse.smallest_eigenvalue / fine.smallest_eigenvalue, 1.0, 1e-3);
}

void expectNone(const Harness& harness) {
  const Equilibrium result = solve(harness, 1e-5);
  ASSERT_TRUE(result.converged()) << result.message;
  EXPECT_EQ(neutralNote(result), "");
  EXPECT_GT(result.smallest_eigenvalue, 0.0);
}

// Between ball joints in any direction, pulled by a share of Euler's load: the first bow, EI π⁴/L³ + P π²/L.
TEST(NeutralMotion, StraightRodBetweenBallJointsIsAsStiffAsItsFirstBow) {
  std::mt19937 random(3);
  std::normal_distribution<double> normal;
  std::uniform_real_distribution<double> share(-0.9, 3.0);
  for (int i = 0; i < 10; ++i) {
    const Vector3d direction = Vector3d(normal(random), normal(random), normal(random)).normalized();
    const double of_euler = share(random), euler = M_PI * M_PI * kEI / (kLength * kLength);
    SCOPED_TRACE(testing::Message() << direction.transpose() << ", pulled by " << of_euler);
    Harness harness = cantilever(rod(), kWeightless);
    harness.clips[0] = clipOn(0, "A", 0.0, pivotClip(), clampAlong(kWeightless, direction, 0.3));
    harness.clips.push_back(
        clipOn(0, "B", kLength, guideClip(true), clampAlong(kLength * direction, direction, 0.0)));
    // a ball joint that is free to move along the rod
    for (ClipFreedom& turn : harness.clips[1].constraint.rotation) turn = ClipFreedom::free();
    harness.loads = {loadAt(0, kLength, of_euler * euler * direction)};
    const Equilibrium result = solve(harness);
    ASSERT_TRUE(result.converged()) << result.message;
    EXPECT_TRUE(tells(result, "'cable' is free to turn about its own axis")) << neutralNote(result);
    const double stiffness = std::pow(M_PI, 4) * kEI / std::pow(kLength, 3) * (1.0 + of_euler);
    EXPECT_NEAR(result.smallest_eigenvalue / stiffness, 1.0, 1e-3);
  }
}

// Round cables between ball joints anywhere, with weight and dead loads.
TEST(NeutralMotion, SpinOfAHangingCableIsTold) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> part(-1.0, 1.0);
  for (int i = 0; i < 10; ++i) {
    SCOPED_TRACE(i);
    Vector3d end(part(random), part(random), part(random));
    end *= (0.5 + 0.4 * std::abs(part(random))) * kLength / end.norm();
    Harness harness = heldBy(clamped(rod(0.05), {end, so3::exp(end)}, kGravity), pivotClip());
    if (i % 2 == 0) harness.loads = {loadAt(0, 0.3, {0.2 * part(random), 0.2 * part(random), -0.3})};
    expectNeutral(harness, "'cable' is free to turn about its own axis");
  }
}

// Clips that let a cable roll do as well; one that does not, a section that is not round, a bent rest shape
// or a sprung roll hold it.
TEST(NeutralMotion, SpinIsHeldByWhatFeelsIt) {
  const Pose end = poseAt(0.6, 0.1, 0.05);
  expectNeutral(heldBy(clamped(rod(0.05), end), rollingClip()), "about its own axis");
  Harness held = heldBy(clamped(rod(0.05), end), rollingClip());
  held.clips[1].constraint = fixedClip();
  expectNone(held);
  Cable strip = rod(0.05);
  strip.sections[0].section.EI_z *= 0.8;
  expectNone(heldBy(clamped(strip, end), rollingClip()));
  Cable formed = rod(0.05);
  formed.rest_curvature = {{0.0, {0.0, 0.4, 0.0}}, {kLength, {0.0, 0.4, 0.0}}};
  expectNone(heldBy(clamped(formed, end), rollingClip()));
  Harness sprung = heldBy(clamped(rod(0.05), end), rollingClip());
  sprung.clips[0].constraint.rotation[0] = ClipFreedom::sprung(0.01);
  expectNone(sprung);
}

// A bow between aligned clamps, anywhere: out of line, or with weight across, its direction is decided.
TEST(NeutralMotion, BowBetweenAlignedClampsTurnsAboutTheirLine) {
  std::mt19937 random(11);
  std::normal_distribution<double> normal;
  for (const double slack : {0.02, 0.1, 0.3}) {
    SCOPED_TRACE(slack);
    const Vector3d direction = Vector3d(normal(random), normal(random), normal(random)).normalized();
    const Vector3d from(0.1, -0.2, 0.3), to = from + (1.0 - slack) * kLength * direction;
    Harness harness = clamped(rod(), clampAlong(to, direction, 0.4), kWeightless);
    harness.clips[0].pose = clampAlong(from, direction, 0.0);
    expectNeutral(harness, "'cable' is free to turn about the line through 'A' and 'B'");
    Harness aside = harness;
    aside.clips[1].pose.orientation = aside.clips[1].pose.orientation * so3::exp({0.0, 0.05, 0.0});
    expectNone(aside);
    Harness heavy = harness;
    heavy.gravity = 9.81 * direction.cross(Vector3d::UnitX()).normalized();
    heavy.cables[0].sections[0].section.mass_per_length = 0.05;
    expectNone(heavy);
    heavy.gravity = 9.81 * direction;
    heavy.cables[0].sections[0].section.mass_per_length = 0.01;
    expectNeutral(heavy, "the line through 'A' and 'B'");
  }
}

// Beyond a pitchfork the amplitude is twice as stiff as the straight shape is short of stiffness: of energy
// ½λa² + ba⁴ the curvature at the minimum is -2λ.
TEST(NeutralMotion, BuckledCantileverIsTwiceAsStiffAsTheStraightOneIsUnstable) {
  const double euler = 0.25 * M_PI * M_PI * kEI / (kLength * kLength);
  const auto at = [&](double share) {
    Harness harness = cantilever(rod(), kWeightless);
    harness.loads = {loadAt(0, kLength, {-share * euler, 0.0, 0.0})};
    return harness;
  };
  const Equilibrium before = solve(at(0.99));
  ASSERT_TRUE(before.converged());
  for (const double beyond : {0.005, 0.01, 0.02}) {
    SCOPED_TRACE(beyond);
    const Equilibrium after = solve(at(1.0 + beyond));
    ASSERT_TRUE(after.converged()) << after.message;
    EXPECT_TRUE(tells(after, "free to turn about the line through 'A' along (1, 0, 0)"))
        << neutralNote(after);
    EXPECT_NEAR(after.smallest_eigenvalue / (2.0 * beyond / 0.01 * before.smallest_eigenvalue), 1.0,
                2.0 * beyond + 1e-3);
  }
}

// A cable below another: turns about its vertical chord and its own axis, the one as good as the other.
TEST(NeutralMotion, VerticalChordLeavesTwo) {
  const Harness harness = heldBy(clamped(rod(0.05), poseAt(0.0, 0.0, 0.7), kGravity), pivotClip());
  expectNeutral(harness,
                "about its own axis; cable 'cable' is free to turn about the line through 'A' and 'B'");
  Harness strip = harness;
  strip.cables[0].sections[0].section.EI_z *= 0.5;
  expectNeutral(strip, "'cable' is free to turn about the line through 'A' and 'B'");
  EXPECT_FALSE(tells(solve(strip), "own axis"));
  Harness aside = harness;
  aside.clips[1].pose.position.x() += 0.05;
  expectNeutral(aside, "about its own axis");
  EXPECT_FALSE(tells(solve(aside), "line through"));
}

// Several cables, joined and apart: each that is free is named, the others are not.
TEST(NeutralMotion, OfSeveralCables) {
  Harness harness = cantilever(rod(0.05));
  harness.cables[0].name = "held";
  harness.cables.push_back(uniformCable(0.5, sectionOf(1e7, 0.05), "hung"));
  harness.joints = {{"joint", Joint::Type::pivot, 0, kLength, 1, 0.0}};
  harness.clips.push_back(clipOn(1, "E", 0.5, pivotClip(), poseAt(0.5, 0.4, 0.0)));
  expectNeutral(harness, ": cable 'hung' is free to turn about its own axis");
  EXPECT_FALSE(tells(solve(harness), "'held'"));
  Harness hinged = harness;
  hinged.joints[0].type = Joint::Type::hinge;
  expectNone(hinged);
  Harness apart = heldBy(clamped(rod(0.05), poseAt(0.6, 0.0, 0.0)), pivotClip());
  apart.cables.push_back(uniformCable(kLength, sectionOf(1e7, 0.05), "other"));
  apart.clips.push_back(clipOn(1, "C", 0.0, rollingClip(), poseAt(0.0, 0.4, 0.0)));
  apart.clips.push_back(clipOn(1, "D", kLength, rollingClip(), poseAt(0.6, 0.4, 0.1)));
  expectNeutral(apart,
                "'cable' is free to turn about its own axis; cable 'other' is free to turn about its own");
}

// A rod so stiff that its swing is nothing beside its bending: λ of a physical pendulum, 3/2 ρA g, all the
// same.
TEST(NeutralMotion, SwingOfAStiffRodIsNone) {
  constexpr double kMass = 0.05;
  for (const double stiffness : {1e2, 1e4}) {
    SCOPED_TRACE(stiffness);
    const double EA = 1e5 * stiffness / (kLength * kLength);
    Harness harness = cantilever(
        uniformCable(kLength, roundSection(EA, 0.4 * EA, 0.8 * stiffness, stiffness, kMass)), kGravity);
    harness.clips[0] = clipOn(0, "A", 0.0, pivotClip(), poseAt(0.0, 0.0, 0.0));
    const Equilibrium result = solve(harness, 1e-5);
    ASSERT_TRUE(result.converged()) << result.message;
    EXPECT_FALSE(tells(result, "line through")) << neutralNote(result);
    EXPECT_NEAR(result.smallest_eigenvalue / (1.5 * kMass * 9.81), 1.0, 1e-3);
  }
}

TEST(NeutralMotion, SlendernessDoesNotMatter) {
  double last = 0.0;
  for (const double slenderness : {1e7, 1e8, 1e9, 1e10}) {
    SCOPED_TRACE(slenderness);
    const Equilibrium result = solve(
        clamped(uniformCable(kLength, sectionOf(slenderness)), poseAt(0.8 * kLength, 0.0, 0.0), kWeightless),
        1e-4);
    ASSERT_TRUE(result.converged()) << result.message;
    EXPECT_TRUE(tells(result, "the line through 'A' and 'B'")) << neutralNote(result);
    if (last > 0.0) {
      EXPECT_NEAR(result.smallest_eigenvalue / last, 1.0, 1e-3);
    }
    last = result.smallest_eigenvalue;
  }
}

// Its derivative is that of the same eigenvalue.
TEST(NeutralMotion, EigenvalueIsDifferentiatedBesideIt) {
  const Harness harness = heldBy(clamped(rod(0.05), poseAt(0.6, 0.1, 0.0)), pivotClip());
  EquilibriumSolver solver;
  ASSERT_TRUE(solver.solve(harness).converged());
  HarnessRate rate;
  rate.clip_frames = {{1, FrameRate{Vector3d::UnitX(), Vector3d::Zero()}}};
  const double derivative = solver.eigenvalueRates({rate}).front();
  const auto at = [&](double by) {
    EquilibriumSolver other = solver;
    Harness moved = harness;
    moved.clips[1].pose.position.x() += by;
    return other.update(moved).smallest_eigenvalue;
  };
  const double slope = (at(1e-3) - at(-1e-3)) / 2e-3;
  EXPECT_NEAR(derivative / slope, 1.0, 1e-2);
}

}  // namespace
}  // namespace cable_variation::test
