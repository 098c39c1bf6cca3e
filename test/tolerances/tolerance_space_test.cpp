// What the tolerances allow together, by what is known of even distributions.
#include <cable_variation/tolerances/tolerance_space.h>

#include <cmath>
#include <string>

#include <gtest/gtest.h>

#include <envelope/envelope_scenes.h>

namespace cable_variation::test {
namespace {

using Eigen::Vector3d;

TEST(tolerance_space, draws_within_the_regions_and_finds_their_farthest_places) {
  Scene scene = freeRod(0.1, 0.004);
  for (const Axis axis : {Axis::x, Axis::y, Axis::z}) {
    addVariable(scene, "t" + std::to_string(static_cast<int>(axis)), ClipTranslation{0, axis}, -0.003, 0.003);
  }
  addVariable(scene, "turn", ClipRotation{0, Axis::z}, -0.1, 0.3);
  scene.tolerance_regions.push_back({"ball", ToleranceRegion::Shape::ball, {0, 1, 2}, 0.003, true, 3.0});
  const ToleranceSpace space(scene, {3, 0, 1, 2});
  const CounterRandom random(5, 1);
  int at_limits = 0;
  double mean_cube = 0.0;
  constexpr int kDraws = 4000;
  for (int i = 0; i < kDraws; ++i) {
    RandomRow numbers(random, static_cast<std::uint64_t>(i));
    const Eigen::VectorXd even = space.random(numbers), limit = space.randomNearLimits(numbers);
    EXPECT_TRUE(space.contains(even));
    EXPECT_TRUE(space.contains(limit));
    mean_cube += std::pow(even.tail<3>().norm() / 0.003, 3) / kDraws;
    at_limits += limit[0] == -0.1 || limit[0] == 0.3 ? 1 : 0;
  }
  EXPECT_NEAR(mean_cube, 0.5, 5.0 * std::sqrt(1.0 / 12.0 / kDraws));  // evenly in a ball: r³ is uniform
  EXPECT_NEAR(at_limits, 0.5 * kDraws, 5.0 * std::sqrt(0.25 * kDraws));
  const Eigen::Vector4d gradient(-2.0, 1.0, 2.0, -2.0);
  const Eigen::VectorXd far = space.farthest(gradient, Eigen::Vector4d::Zero());
  EXPECT_NEAR(far[0], -0.1, 0.0);
  EXPECT_NEAR((far.tail<3>() - 0.003 * Vector3d(1.0, 2.0, -2.0) / 3.0).norm(), 0.0, 1e-15);
  EXPECT_FALSE(space.contains(Eigen::Vector4d(0.0, 0.003, 0.003, 0.0)));
}

}  // namespace
}  // namespace cable_variation::test
