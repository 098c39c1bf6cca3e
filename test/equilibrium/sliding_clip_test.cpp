// A tight channel pushes the cable along its axis by M²/2EI, the configurational
// force of a sliding sleeve (Bigoni, Dal Corso, Bosi and Misseroni 2013).

#include <gtest/gtest.h>

#include <equilibrium/cases.h>

namespace cable_variation::test {
namespace {

constexpr double kLength = 1.0, kSleeve = 0.3, kEI = 1.0;

// Nearly inextensible: (M²/2EI)/EA is 1e-6. The part before the sleeve is straight on its axis.
Harness rodInSleeve(const ClipConstraint& sleeve, const Eigen::Vector3d& tip_force) {
  Harness harness =
      cantilever(uniformCable(kLength, roundSection(1e5, 1e5, 0.8, kEI)), Eigen::Vector3d::Zero());
  harness.clips.push_back(clipOn(0, "sleeve", kSleeve, sleeve, poseAt(kSleeve, 0.0, 0.0)));
  harness.clips.push_back(clipOn(0, "tip", kLength, freeClip()));
  harness.loads = {loadAt(0, kLength, tip_force)};
  return harness;
}

struct AroundSleeve {
  ShapePoint before, after;
  double arc_length;
};

AroundSleeve aroundSleeve(const Equilibrium& result) {
  const auto& points = result.shapes.at(0).points;
  std::size_t i = 0;
  while (points[i + 1].arc_length > points[i].arc_length) ++i;
  return {points[i], points[i + 1], result.clip_reactions.at(1).arc_length};
}

class SlidingSleeve : public testing::TestWithParam<Eigen::Vector3d> {};

TEST_P(SlidingSleeve, PushesTheRodOutByTheConfigurationalForce) {
  const Equilibrium result = solve(rodInSleeve(slidingClip(), GetParam()), 1e-7);
  ASSERT_TRUE(result.converged()) << result.message;
  const AroundSleeve at = aroundSleeve(result);
  const double bending = at.after.moment.tail<2>().squaredNorm() / (2.0 * kEI);
  ASSERT_GT(bending, 0.5);
  EXPECT_LT(at.before.moment.norm(), 1e-6);  // straight before the sleeve
  EXPECT_NEAR(at.after.force.x(), GetParam().x(), 1e-8);
  // h continuous: n₋ + n₋²/2EA = n₊ + |f₊|²/2EA + M₊²/2EI; 1e-5 relative is left of the stretch and grid
  const double stretch = (GetParam().squaredNorm() - std::pow(at.before.force.x(), 2)) / 2e5;
  EXPECT_NEAR(at.before.force.x() - at.after.force.x() - stretch, bending, 1e-5 * bending);
  // the part before the sleeve is stretched by n₋, so it has slid that much
  EXPECT_NEAR(at.arc_length, kSleeve / (1.0 + at.before.force.x() / 1e5), 1e-8);
  EXPECT_NEAR(result.clip_reactions[1].force.x(), at.before.force.x() - at.after.force.x(), 1e-8);
}

INSTANTIATE_TEST_SUITE_P(TipForces, SlidingSleeve,
                         testing::Values(Eigen::Vector3d(0.0, 2.0, 0.0), Eigen::Vector3d(0.0, -1.0, 2.5),
                                         Eigen::Vector3d(1.5, 0.0, 2.0), Eigen::Vector3d(-1.0, 2.0, 0.0)));

// A sleeve that turns takes no moment, so it pushes by nothing but the small n²/2EA and shear terms.
TEST(Eyelet, TransmitsTheMomentAndHardlyPushes) {
  const Eigen::Vector3d force(0.5, 0.4, 0.0);
  const Equilibrium result = solve(rodInSleeve(eyeletClip(), force), 1e-7);
  ASSERT_TRUE(result.converged()) << result.message;
  const AroundSleeve at = aroundSleeve(result);
  ASSERT_GT(at.after.moment.norm(), 0.1);
  EXPECT_LT((at.before.moment - at.after.moment).norm(), 1e-6);
  const Eigen::Vector3d tangent = at.after.pose.orientation * Eigen::Vector3d::UnitX();
  EXPECT_NEAR((at.before.force - at.after.force).dot(tangent), 0.0, 1e-3);
  EXPECT_GT((at.before.force - at.after.force).norm(), 0.5);  // but holds it in place
}

// Two clamps with a sliding clip between them, from `before` of a straight cable on; the clip starts 4 mm
// behind the first clamp.
Harness slidingBetweenClamps(double before, double length) {
  Harness harness;
  harness.cables = {uniformCable(length, solidSection(0.004, {1e8, 0.25, 2000.0}))};
  harness.clips = {
      clipOn(0, "A", before, fixedClip(), poseAt(0.0, 0.0, 0.0)),
      clipOn(0, "slides", before + 0.004, slidingClip(), poseAt(0.07, 0.02, 0.01, {0.0, 0.1, 0.4})),
      clipOn(0, "B", before + 0.2, fixedClip(), poseAt(0.17, 0.03, 0.0, {0.2, 0.0, -0.3}))};
  return harness;
}

// Beyond its clamps a cable does nothing to what is between them: a clip comes to rest at the same place of a
// long cable as of a short one, however short its room is of the whole.
TEST(SlidingClipRoom, FindsItsPlaceInAShortRoomOfALongCable) {
  const Equilibrium alone = solve(slidingBetweenClamps(0.0, 0.2), 1e-6);
  ASSERT_TRUE(alone.converged()) << alone.message;
  const double place = alone.clip_reactions[1].arc_length;
  for (const double before : {0.5, 2.0, 4.0}) {
    const Equilibrium result = solve(slidingBetweenClamps(before, before + 2.0), 1e-6);
    ASSERT_TRUE(result.converged()) << before << ": " << result.message;
    EXPECT_NEAR(result.clip_reactions[1].arc_length - before, place, 1e-5) << before;
    EXPECT_LT((result.clip_reactions[1].force - alone.clip_reactions[1].force).norm(),
              1e-3 * alone.clip_reactions[1].force.norm());
  }
}

// Fixed at the same place, the sleeve's axial reaction is what the tip pulls, and nothing slides.
TEST(FixedSleeve, HasNoConfigurationalForce) {
  const Equilibrium result = solve(rodInSleeve(fixedClip(), {0.0, 2.0, 0.0}), 1e-7);
  ASSERT_TRUE(result.converged()) << result.message;
  const AroundSleeve at = aroundSleeve(result);
  ASSERT_GT(at.after.moment.norm(), 1.0);
  EXPECT_NEAR(at.before.force.x(), 0.0, 1e-6);
  EXPECT_NEAR(result.clip_reactions[1].force.x(), 0.0, 1e-6);
  EXPECT_EQ(at.arc_length, kSleeve);
}

}  // namespace
}  // namespace cable_variation::test
