// Slender cables: a wire of one metre has κ = EA L²/EI of 1e7, a bundle with measured stiffness 1e8 to 1e10.
// Their shape is that of a cable without stretch, so κ must not matter.

#include <random>

#include <gtest/gtest.h>

#include <cable_variation/equilibrium/neutral_note.h>
#include <equilibrium/cases.h>

namespace cable_variation::test {
namespace {

constexpr double kEI = 1e-2;  // [N m²], of cables of one metre

Section withSlenderness(double slenderness) {
  const double EA = slenderness * kEI;
  return {EA, 0.4 * EA, 0.4 * EA, 0.77 * kEI, kEI, kEI, 0.05, 1e-3};
}

Section steelWire(double radius) { return solidSection(radius, {210e9, 0.3, 7850.0}); }

Eigen::Quaterniond randomRotation(std::mt19937& generator, double largest) {
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  Eigen::Vector3d axis(uniform(generator), uniform(generator), uniform(generator));
  return so3::exp(largest * std::abs(uniform(generator)) * axis.normalized());
}

// Clamped ends anywhere, and a clip of another kind about the middle.
Harness randomHarness(double slenderness, const std::optional<ClipConstraint>& middle, bool free_end,
                      unsigned seed) {
  std::mt19937 generator(seed);
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  const auto vector = [&] {
    return Eigen::Vector3d(uniform(generator), uniform(generator), uniform(generator));
  };
  Harness harness = cantilever(uniformCable(1.0, withSlenderness(slenderness)));
  const Eigen::Vector3d direction = Eigen::Vector3d(1.0, 0.5 * vector().y(), 0.5 * vector().z()).normalized();
  const double distance = 0.75 + 0.2 * uniform(generator);
  if (free_end) {
    harness.clips[0].pose.orientation = randomRotation(generator, 3.0);
    return harness;
  }
  harness.clips.push_back(
      clipOn(0, "B", 1.0, fixedClip(), {distance * direction, randomRotation(generator, 1.2)}));
  if (!middle) return harness;
  const Eigen::Quaterniond along =
      so3::smallestRotation(Eigen::Vector3d::UnitX(), direction) * randomRotation(generator, 0.4);
  harness.clips.push_back(clipOn(0, "M", 0.5 + 0.1 * uniform(generator), *middle,
                                 {0.5 * distance * direction + 0.08 * vector(), along}));
  return harness;
}

struct SlenderCase {
  const char* name;
  std::optional<ClipConstraint> middle;
  bool free_end;
};

class Slender : public testing::TestWithParam<SlenderCase> {};

// The grid adapts to each by itself, so shapes may differ by what both are off the continuum; with a
// thousandth of the stretch they differ by that.
TEST_P(Slender, IsSolvedWhateverItsStretchAndTakesTheSameShape) {
  for (unsigned seed = 0; seed < 12; ++seed) {
    std::optional<Equilibrium> before;
    for (const double slenderness : {1e7, 1e8, 1e9, 1e10}) {
      SCOPED_TRACE(testing::Message() << "harness " << seed << ", slenderness " << slenderness);
      const Equilibrium result =
          solve(randomHarness(slenderness, GetParam().middle, GetParam().free_end, seed));
      ASSERT_TRUE(result.converged()) << result.message;
      EXPECT_GE(result.smallest_eigenvalue, 0.0);
      EXPECT_LE(result.discretisation_error, 1e-4);
      if (before &&
          std::abs(before->energy.total() - result.energy.total()) < 1e-3 * std::abs(result.energy.elastic)) {
        for (int i = 0; i <= 20; ++i) {
          const double s = 0.05 * i;
          EXPECT_LT((before->shapes[0].position(s) - result.shapes[0].position(s)).norm(), 3e-4) << s;
        }
      }
      before = result;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Clips, Slender,
                         testing::Values(SlenderCase{"fixed", std::nullopt, false},
                                         SlenderCase{"eyelet", eyeletClip(), false},
                                         SlenderCase{"sliding_rolling", slidingRollingClip(), false},
                                         SlenderCase{"sliding", slidingClip(), false},
                                         SlenderCase{"free_end", std::nullopt, true}),
                         [](const auto& of) { return of.param.name; });

// A turn about the chord costs nothing: no ground to refine for ever, nor to call the shape unstable.
TEST(AlignedClamps, BowWithSlack) {
  for (const double slenderness : {1e6, 1e7, 1e8, 1e9}) {
    for (const double slack : {0.02, 0.1, 0.2, 0.35, 0.5}) {
      SCOPED_TRACE(testing::Message() << "slenderness " << slenderness << ", slack " << slack);
      const Equilibrium result = solve(clamped(uniformCable(1.0, withSlenderness(slenderness)),
                                               poseAt(1.0 - slack, 0.0, 0.0), Eigen::Vector3d::Zero()));
      ASSERT_TRUE(result.converged()) << result.message;
      EXPECT_LT(result.discretisation_error, 1e-4);
      EXPECT_NE(neutralNote(result).find("the line through 'A' and 'B'"), std::string::npos);
      EXPECT_GT(result.smallest_eigenvalue, 100.0 * kEI);  // of others: the first bow of a straight one is 97
      EXPECT_GT(result.shapes[0].position(0.5).tail<2>().norm(), 0.05);
    }
  }
}

// Steel, 0.5 mm: 1.3 m leave a clamp at 27° to the vertical and hang. From an adaptive Runge-Kutta
// integration.
TEST(SteelWire, HangsFromAClampAtAnAngle) {
  Harness harness = cantilever(uniformCable(1.3, steelWire(0.5e-3)));
  harness.clips[0].pose.orientation =
      so3::smallestRotation(Eigen::Vector3d::UnitX(), Eigen::Vector3d(0.5, 0.0, 1.0).normalized());
  const Equilibrium result = solve(harness);
  ASSERT_TRUE(result.converged()) << result.message;
  const Eigen::Vector3d tip = result.shapes[0].points.back().pose.position;
  EXPECT_LT((tip - Eigen::Vector3d(1.079, 0.0, -0.358)).norm(), 1e-3);
  EXPECT_NEAR(result.energy.total(), 0.02377, 2e-5);
}

TEST(CopperWire, HangsWhateverItsLength) {
  const Section section = solidSection(0.5e-3, {120e9, 0.34, 8900.0});
  for (double length = 1.0; length < 1.35; length += 0.05) {
    Harness harness = cantilever(uniformCable(length, section));
    harness.clips[0].pose.orientation =
        so3::smallestRotation(Eigen::Vector3d::UnitX(), Eigen::Vector3d(1.0, 0.0, 1.0).normalized());
    const Equilibrium result = solve(harness);
    ASSERT_TRUE(result.converged()) << length << " m: " << result.message;
    if (std::abs(length - 1.1) > 1e-9) continue;
    const Eigen::Vector3d tip = result.shapes[0].points.back().pose.position;
    EXPECT_LT((tip - Eigen::Vector3d(0.7775, 0.0, -0.5862)).norm(), 1e-3) << tip.transpose();
  }
}

// A ring on a hair-thin wire between aligned clamps rests on one side of the middle, or mirrored on the
// other.
TEST(SteelHair, CarriesAnEyelet) {
  Harness harness = clamped(uniformCable(1.0, steelWire(0.1e-3)), poseAt(0.8, 0.0, 0.0));
  harness.clips.push_back(clipOn(0, "ring", 0.5, eyeletClip(), poseAt(0.4, 0.0, 0.0)));
  const Equilibrium result = solve(harness);
  ASSERT_TRUE(result.converged()) << result.message;
  EXPECT_NEAR(std::abs(result.clip_reactions[2].arc_length - 0.5), 0.088, 2e-3);
  EXPECT_NEAR(result.energy.total(), 1.7e-4, 2e-6);
}

// The place of a ring does not depend on how little the cable stretches.
TEST(SlenderEyelet, RestsAtTheSamePlaceWhateverTheStretch) {
  for (const double EA : {7e5, 1e6, 1e7, 1e8, 1e9}) {
    Harness harness = clamped(uniformCable(0.36, roundSection(EA, 0.4 * EA, 0.016, 0.02, 0.3)),
                              poseAt(0.3, 0.0, 0.05, {0.0, 0.0, M_PI / 6.0}));
    harness.clips.push_back(clipOn(0, "ring", 0.18, eyeletClip(), poseAt(0.15, 0.02, 0.03)));
    const Equilibrium result = solve(harness);
    ASSERT_TRUE(result.converged()) << EA << " N: " << result.message;
    EXPECT_NEAR(result.clip_reactions[2].arc_length, 0.17181, 2e-4) << EA << " N";
  }
}

// update() follows slender shapes as it follows others: with clamp B moved by some millimetres and degrees.
TEST(Slender, IsFollowed) {
  for (const double slenderness : {1e6, 1e8, 1e10}) {
    const Harness nominal = randomHarness(slenderness, std::nullopt, false, 3);
    EquilibriumSolver solver;
    ASSERT_TRUE(solver.solve(nominal).converged());
    std::mt19937 generator(1);
    std::uniform_real_distribution<double> uniform(-1.0, 1.0);
    for (int i = 0; i < 10; ++i) {
      Harness harness = nominal;
      Pose& clamp = harness.clips[1].pose;
      clamp.position += 5e-3 * Eigen::Vector3d(uniform(generator), uniform(generator), uniform(generator));
      clamp.orientation = clamp.orientation * randomRotation(generator, 0.08);
      const Equilibrium followed = solver.update(harness);
      ASSERT_TRUE(followed.converged()) << slenderness << ": " << followed.message;
      EXPECT_LT(followed.iterations, 60) << slenderness;
      const Equilibrium alone = solve(harness);
      EXPECT_LT((followed.shapes[0].position(0.5) - alone.shapes[0].position(0.5)).norm(), 3e-4);
    }
  }
}

// Map coordinates: a scene a thousand kilometres from the origin is solved, or it is said that its positions
// are rounded too much.
TEST(FarFromTheOrigin, ShapesAreTheSameOrRefused) {
  for (const double slenderness : {1e3, 1e5, 1e7, 1e8}) {
    Harness harness =
        clamped(uniformCable(1.0, withSlenderness(slenderness)), poseAt(0.7, 0.1, 0.0, {0.0, 0.3, 0.5}));
    const Equilibrium near = solve(harness, 1e-4);
    for (const double distance : {1e3, 1e5, 1e6, 1e8}) {
      SCOPED_TRACE(testing::Message() << "slenderness " << slenderness << ", " << distance << " m");
      const Eigen::Vector3d shift(distance, -distance, 0.3 * distance);
      Harness moved = harness;
      for (Clip& clip : moved.clips) clip.pose.position += shift;
      const Equilibrium far = solve(moved, 1e-4);
      if (distance <= 1e6 && slenderness <= 1e7) {
        ASSERT_TRUE(far.converged()) << far.message;
      }
      if (!far.converged()) continue;
      EXPECT_LT((far.shapes[0].position(0.5) - shift - near.shapes[0].position(0.5)).norm(), 3e-4);
      EXPECT_NEAR(far.clip_reactions[1].force.norm(), near.clip_reactions[1].force.norm(),
                  0.03 * near.clip_reactions[1].force.norm());
    }
  }
}

}  // namespace
}  // namespace cable_variation::test
