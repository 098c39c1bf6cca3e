// Spread and worst case of design variables together, against sampling of the regions and closed forms.
#include <cable_variation/tolerances/tolerances.h>

#include <cmath>
#include <random>
#include <stdexcept>
#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace cable_variation {
namespace {

// a, b: normal, standard deviations 1 and 2; c: uniform from 0 to 6; then a ball of radius 2, with its
// coordinates p, q, r.
Scene someVariables() {
  Scene scene;
  const auto add = [&](const std::string& name, double lower, double upper, const std::string& distribution) {
    DesignVariable variable;
    variable.name = name;
    variable.lower = lower;
    variable.upper = upper;
    variable.distribution = distribution;
    scene.design_variables.push_back(variable);
  };
  add("a", -3.0, 3.0, "normal");
  add("b", -6.0, 6.0, "normal");
  add("c", 0.0, 6.0, "uniform");
  for (const char* name : {"p", "q", "r"}) add(name, -2.0, 2.0, "ball");
  ToleranceRegion ball;
  ball.name = "ball";
  ball.variables = {3, 4, 5};
  ball.radius = 2.0;
  scene.tolerance_regions = {ball};
  return scene;
}

TEST(Spread, OfVariablesAndACorrelation) {
  Scene scene = someVariables();
  scene.correlations = {{0, 2, -0.5}};
  const Spread spread = spreadOf(scene, {2, 0, 1});
  EXPECT_NEAR(spread.mean[0], 3.0, 1e-14);
  EXPECT_NEAR(spread.mean[1], 0.0, 1e-14);
  EXPECT_NEAR(spread.covariance(0, 0), 3.0, 1e-13);  // 6²/12
  EXPECT_NEAR(spread.covariance(1, 1), 1.0, 1e-14);
  EXPECT_NEAR(spread.covariance(2, 2), 4.0, 1e-13);
  EXPECT_NEAR(spread.covariance(0, 1), -0.5 * std::sqrt(3.0), 1e-13);
  EXPECT_EQ(spread.covariance(1, 0), spread.covariance(0, 1));
  EXPECT_EQ(spread.covariance(1, 2), 0.0);
}

TEST(Spread, OfABallIsThatOfPointsInIt) {
  const Spread spread = spreadOf(someVariables(), {3, 4, 5});
  std::mt19937 random(1);
  std::uniform_real_distribution<double> side(-2.0, 2.0);
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
  int count = 0;
  for (int i = 0; i < 400000; ++i) {
    const double x = side(random), y = side(random), z = side(random);
    const Eigen::Vector3d point(x, y, z);
    if (point.norm() > 2.0) continue;
    covariance += point * point.transpose();
    ++count;
  }
  // four standard errors of 200,000 squares
  EXPECT_LT((spread.covariance - covariance / count).cwiseAbs().maxCoeff(), 0.01);
}

TEST(Spread, RefusesCorrelationsThatNoProductionHas) {
  Scene scene = someVariables();
  scene.correlations = {{0, 1, 0.9}, {1, 2, 0.9}, {0, 2, -0.9}};
  EXPECT_NO_THROW(spreadOf(scene, {0, 1}));
  try {
    spreadOf(scene, {0, 1, 2, 3});
    FAIL() << "taken";
  } catch (const std::invalid_argument& error) {
    // eigenvalues 1 - 2 * 0.9, 1.9, 1.9
    EXPECT_EQ(
        std::string(error.what()),
        "the correlations of 'a', 'b', 'c' are not positive definite, smallest eigenvalue -0.8; expected "
        "more than 0");
  }
  EXPECT_THROW(spreadOf(scene, {6}), std::invalid_argument);
}

TEST(WorstCase, OfABoxIsAtItsCorners) {
  const Scene scene = someVariables();
  const WorstCase worst = worstCase(scene, {0, 2}, Eigen::Vector2d(2.0, -1.0));
  EXPECT_DOUBLE_EQ(worst.low, -2.0 * 3.0 - 6.0);
  EXPECT_DOUBLE_EQ(worst.high, 2.0 * 3.0);
}

TEST(WorstCase, OfABallIsWhereTheGradientLeavesIt) {
  const Scene scene = someVariables();
  const WorstCase worst = worstCase(scene, {3, 0, 5, 4}, Eigen::Vector4d(1.0, 0.5, 2.0, -2.0));
  EXPECT_DOUBLE_EQ(worst.high, 2.0 * 3.0 + 0.5 * 3.0);  // |(1, -2, 2)| = 3
  EXPECT_DOUBLE_EQ(worst.low, -worst.high);
  EXPECT_DOUBLE_EQ(worstCase(scene, {4}, Eigen::VectorXd::Constant(1, 3.0)).high, 6.0)
      << "a part of the ball";
  EXPECT_THROW(worstCase(scene, {4}, Eigen::Vector2d(1.0, 1.0)), std::invalid_argument);
}

}  // namespace
}  // namespace cable_variation
