// Case W, which has saddles to fall for, from cold in many poses of its clamp B.

#include <random>

#include <gtest/gtest.h>

#include <equilibrium/cases.h>
#include <equilibrium/fixed_grid.h>

namespace cable_variation::test {
namespace {

// Clamp B within ±20 mm along and ±20° about each axis.
Harness randomPose(std::mt19937& generator) {
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  const auto within = [&](double bound) -> Eigen::Vector3d {
    const double x = uniform(generator), y = uniform(generator), z = uniform(generator);
    return bound * Eigen::Vector3d(x, y, z);
  };
  Harness harness = caseW();
  Pose& clamp = harness.clips[1].pose;
  clamp.position += within(0.02);
  clamp.orientation = clamp.orientation * so3::exp(within(20.0 * M_PI / 180.0));
  return harness;
}

TEST(RandomPoses, AllOfAThousandAreSolvedToAStableShape) {
  std::mt19937 generator(2024);
  EquilibriumSolver solver;
  for (int i = 0; i < 1000; ++i) {
    const Equilibrium result = solver.solve(randomPose(generator));
    ASSERT_TRUE(result.converged()) << "pose " << i << ": " << result.message;
    ASSERT_GT(result.smallest_eigenvalue, 0.0) << "pose " << i;
    ASSERT_LE(result.discretisation_error, 1e-4) << "pose " << i;
  }
}

// The lowest stable energy that a hundred starts of our own lead to: the natural shape with every bulge and
// extra turn, each thrown about at random.
double lowestOfManyStarts(const Harness& harness, std::mt19937& generator) {
  FixedGrid rod(harness, 8);
  const InitialShape initial(rod.harness, rod.topology);
  double lowest = INFINITY;
  for (int start = 0; start < 100; ++start) {
    const Routing routing{static_cast<Routing::Bulge>(start % 5), start / 5 % 3 - 1};
    rod.configuration = initial.make(rod.system.grid(), {routing});
    const NodalField away = rod.randomMotion(generator, 0.01, 0.5);
    rod.system.move(away, rod.configuration);
    if (minimise(rod.system, rod.configuration).stable()) {
      lowest = std::min(lowest, rod.system.energy().total());
    }
  }
  return lowest;
}

TEST(RandomPoses, NoneHasALowerShapeThanTheOneFound) {
  std::mt19937 generator(7);
  for (int i = 0; i < 30; ++i) {
    const Harness harness = randomPose(generator);
    const Equilibrium found = solve(harness, 1e-5);
    ASSERT_TRUE(found.converged()) << found.message;
    const double lowest = lowestOfManyStarts(harness, generator);
    ASSERT_TRUE(std::isfinite(lowest));
    // the grids differ: 8 elements are good to 1e-5 of the energy
    EXPECT_LE(found.energy.total(), lowest + 1e-4 * std::abs(lowest)) << "pose " << i;
  }
}

}  // namespace
}  // namespace cable_variation::test
