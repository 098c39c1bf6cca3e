// A part's own variation against closed forms of its locating scheme and against samples of exact poses.
#include <cable_variation/sensitivity/component_variation.h>

#include <array>
#include <cmath>
#include <random>
#include <stdexcept>

#include <gtest/gtest.h>

#include <cable_variation/scene/locating_scheme.h>

namespace cable_variation {
namespace {

using Eigen::Vector3d;

constexpr double kTolerance = 0.5e-3;        // of every locator [m]
constexpr double kSigma = kTolerance / 3.0;  // normal, three of them at the tolerance [m]
constexpr double kWidth = 0.2;               // between locators 0 and 1 [m]
constexpr double kHeight = 0.1;              // of locator 2 above their line [m]

/// A plate in the plane z = 0 of its frame: three locators along z, two along y, one along x.
Scene plateScene() {
  Scene scene;
  Component plate;
  plate.name = "plate";
  plate.locators = {{{0.0, 0.0, 0.0}, Vector3d::UnitZ()},     {{kWidth, 0.0, 0.0}, Vector3d::UnitZ()},
                    {{0.0, kHeight, 0.0}, Vector3d::UnitZ()}, {{0.0, 0.0, 0.0}, Vector3d::UnitY()},
                    {{kWidth, 0.0, 0.0}, Vector3d::UnitY()},  {{0.0, 0.0, 0.0}, Vector3d::UnitX()}};
  scene.components.push_back(plate);
  for (std::size_t i = 0; i < 6; ++i) {
    DesignVariable variable;
    variable.name = "locator_" + std::to_string(i);
    variable.target = LocatorDeviation{0, i};
    variable.unit = "m";
    variable.lower = -kTolerance;
    variable.upper = kTolerance;
    variable.distribution_parameters = {{"sigma", 3.0}};
    scene.design_variables.push_back(variable);
  }
  return scene;
}

TEST(ComponentVariation, OfAPlaneIsInterpolatedBetweenItsLocators) {
  const Scene scene = plateScene();
  const ComponentVariation variation = componentVariation(scene, 0, {0, 1, 2});
  for (const Vector3d& point : {Vector3d(0.0, 0.0, 0.0), Vector3d(kWidth, 0.0, 0.0), Vector3d(0.1, 0.05, 0.0),
                                Vector3d(0.4, 0.3, 0.0), Vector3d(-0.2, -0.1, 0.0)}) {
    // The plane through three heights: weights u and v of locators 1 and 2, the rest of locator 0.
    const double u = point.x() / kWidth, v = point.y() / kHeight;
    const double expected = 6.0 * kSigma * std::sqrt((1 - u - v) * (1 - u - v) + u * u + v * v);
    const PointVariation found = variationAt(variation, point);
    EXPECT_NEAR(found.six_sigma, expected, 1e-12) << point.transpose();
    EXPECT_NEAR(std::abs(found.direction.z()), 1.0, 1e-9) << point.transpose();
    EXPECT_LT(found.mean_shift.norm(), 1e-15);
  }
}

TEST(ComponentVariation, OfCloseLocatorsGrowsFasterAwayFromThem) {
  Scene close = plateScene();
  close.components[0].locators[1].first.x() = 0.25 * kWidth;
  close.components[0].locators[4].first.x() = 0.25 * kWidth;
  const Vector3d far(2.0 * kWidth, 0.0, 0.0);
  const auto own = ownVariables(close, 0);
  const double spread_well = variationAt(componentVariation(plateScene(), 0, own), far).six_sigma;
  const double spread_badly = variationAt(componentVariation(close, 0, own), far).six_sigma;
  // Along z and along y the same lever: weights (1 - u, u) with u = 2 and u = 8.
  EXPECT_NEAR(spread_well, 6.0 * kSigma * std::sqrt(1.0 + 4.0), 1e-12);
  EXPECT_NEAR(spread_badly, 6.0 * kSigma * std::sqrt(49.0 + 64.0), 1e-12);
}

TEST(ComponentVariation, IsThatOfSampledExactPoses) {
  Scene scene = plateScene();
  // Anywhere in the world, at an angle: covariances must turn with the part.
  Pose& pose = scene.components[0].pose;
  pose.position = {1.0, -2.0, 0.5};
  pose.orientation = Eigen::AngleAxisd(0.7, Vector3d(1.0, 2.0, -1.0).normalized());
  const std::array<Vector3d, 4> points = {Vector3d(0.0, 0.0, 0.0), Vector3d(0.3, -0.2, 0.1),
                                          Vector3d(-0.5, 0.4, 0.2), Vector3d(0.1, 0.05, 0.4)};
  constexpr int kSamples = 40000;
  std::mt19937_64 random(20240611);
  std::normal_distribution<double> normal(0.0, kSigma);
  std::array<Eigen::Matrix3d, 4> sums;
  sums.fill(Eigen::Matrix3d::Zero());
  for (int sample = 0; sample < kSamples; ++sample) {
    std::array<double, 6> deviations;
    for (double& deviation : deviations) deviation = normal(random);
    const Pose motion = locatedPose(scene.components[0].locators, deviations);
    for (std::size_t i = 0; i < points.size(); ++i) {
      const Vector3d shift = pose.orientation * (motion * points[i] - points[i]);
      sums[i] += shift * shift.transpose() / kSamples;
    }
  }
  const ComponentVariation variation = componentVariation(scene, 0, ownVariables(scene, 0));
  for (std::size_t i = 0; i < points.size(); ++i) {
    const PointVariation found = variationAt(variation, pose * points[i]);
    const double sampled = std::sqrt(found.direction.dot(sums[i] * found.direction));
    // A standard deviation from n samples is off by 1/sqrt(2 n) = 0.35 %; five times that.
    EXPECT_NEAR(found.six_sigma, 6.0 * sampled, 0.018 * found.six_sigma) << i;
    // No direction varies more: the sampled largest eigenvalue is that one.
    for (const Vector3d& other :
         {Vector3d(Vector3d::UnitX()), Vector3d(Vector3d::UnitY()), Vector3d(1.0, 1.0, 1.0).normalized()}) {
      EXPECT_LE(6.0 * std::sqrt(other.dot(sums[i] * other)), 1.018 * found.six_sigma) << i;
    }
  }
}

TEST(ComponentVariation, MeansOffTheNominalShiftThePart) {
  Scene scene = plateScene();
  for (std::size_t i = 0; i < 3; ++i) {
    scene.design_variables[i].distribution = "uniform";
    scene.design_variables[i].distribution_parameters.clear();
    scene.design_variables[i].lower = 0.0;
  }
  const PointVariation found =
      variationAt(componentVariation(scene, 0, ownVariables(scene, 0)), {0.07, 0.03, 0.0});
  EXPECT_LT((found.mean_shift - Vector3d(0.0, 0.0, 0.5 * kTolerance)).norm(), 1e-12);
}

TEST(ComponentVariation, IsLargestAtTheVertexThatNoOtherExceeds) {
  Scene scene = plateScene();
  scene.components[0].pose.position = {0.3, 0.0, 1.0};
  TriangleMesh mesh;
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> place(-0.3, 0.3);
  for (int i = 0; i < 500; ++i) mesh.vertices.emplace_back(place(random), place(random), place(random));
  Visual visual;
  visual.pose.position = {0.0, 0.1, 0.0};
  visual.mesh = std::make_shared<const TriangleMesh>(mesh);
  scene.components[0].visuals.push_back(visual);
  const Pose pose = componentPose(scene, "plate");
  const ComponentVariation variation = componentVariation(scene, 0, ownVariables(scene, 0));
  double expected = 0.0;
  for (const Vector3d& vertex : mesh.vertices) {
    expected = std::max(expected, variationAt(variation, pose * (visual.pose * vertex)).six_sigma);
  }
  const PointVariation largest = largestVariation(scene, variation, pose);
  EXPECT_NEAR(largest.six_sigma, expected, 1e-12 * expected);
  EXPECT_EQ(variationAt(variation, largest.point).six_sigma, largest.six_sigma);

  scene.components[0].visuals.clear();
  EXPECT_EQ(largestVariation(scene, variation, pose).point, pose.position);
}

TEST(ComponentVariation, OfAnotherPartsVariablesIsNone) {
  Scene scene = plateScene();
  scene.components.push_back(scene.components[0]);
  scene.components[1].name = "other";
  EXPECT_TRUE(ownVariables(scene, 1).empty());
  EXPECT_EQ(variationAt(componentVariation(scene, 1, {0, 1, 2}), {0.3, 0.2, 0.1}).six_sigma, 0.0);
  EXPECT_THROW(componentVariation(scene, 2, {}), std::invalid_argument);
}

}  // namespace
}  // namespace cable_variation
