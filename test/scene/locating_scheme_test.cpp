#include <cable_variation/scene/locating_scheme.h>

#include <cmath>
#include <stdexcept>
#include <string>

#include <gtest/gtest.h>

namespace cable_variation {
namespace {

using Eigen::Vector3d;

// Three points on the floor, two on the side, one at the front.
Locators threeTwoOne() {
  return {{{0.0, 0.0, 0.0}, Vector3d::UnitZ()},  {{0.2, 0.0, 0.0}, Vector3d::UnitZ()},
          {{0.0, 0.1, 0.0}, Vector3d::UnitZ()},  {{0.0, 0.0, 0.02}, Vector3d::UnitY()},
          {{0.2, 0.0, 0.02}, Vector3d::UnitY()}, {{0.0, 0.05, 0.02}, Vector3d::UnitX()}};
}

void expectSatisfied(const Locators& locators, const std::array<double, 6>& deviations) {
  const Pose motion = locatedPose(locators, deviations);
  EXPECT_NEAR(motion.orientation.norm(), 1.0, 1e-14);
  for (std::size_t i = 0; i < 6; ++i) {
    const auto& [point, direction] = locators[i];
    EXPECT_NEAR(direction.dot(motion * point - point), deviations[i], 1e-12) << i;
  }
}

TEST(LocatingScheme, noDeviationIsNoMotion) {
  const Pose motion = locatedPose(threeTwoOne(), {});
  EXPECT_EQ(motion.position.norm(), 0.0);
  EXPECT_EQ(motion.orientation.vec().norm(), 0.0);
}

TEST(LocatingScheme, equalDeviationsOfAPlaneShiftThePart) {
  const Pose motion = locatedPose(threeTwoOne(), {1e-3, 1e-3, 1e-3, 0.0, 0.0, 0.0});
  EXPECT_NEAR((motion.position - Vector3d(0.0, 0.0, 1e-3)).norm(), 0.0, 1e-13);
  EXPECT_NEAR(motion.orientation.vec().norm(), 0.0, 1e-13);
}

TEST(LocatingScheme, oneDeviationOfAPairTurnsThePart) {
  const Pose motion = locatedPose(threeTwoOne(), {0.0, 1e-3, 0.0, 0.0, 0.0, 0.0});
  // the point at 0.2 m rises by 1 mm: sin(angle) = 0.005 about -y
  EXPECT_NEAR(2.0 * std::asin(motion.orientation.vec().norm()), std::asin(0.005), 1e-7);
  EXPECT_LT(motion.orientation.y(), 0.0);
}

TEST(LocatingScheme, isSolvedExactlyForLargeDeviations) {
  expectSatisfied(threeTwoOne(), {1e-3, -2e-3, 0.5e-3, 1e-3, -1e-3, 2e-3});
  expectSatisfied(threeTwoOne(), {0.01, -0.02, 0.015, 0.02, -0.01, 0.02});
}

TEST(LocatingScheme, whatNoMotionSatisfiesIsRefused) {
  // the two side locators are 0.2 m apart; no turn brings them 0.5 m apart in height
  EXPECT_THROW(locatedPose(threeTwoOne(), {0.0, 0.5, 0.0, 0.0, 0.0, 0.0}), std::invalid_argument);
}

TEST(LocatingScheme, singularOnesAreNamedWithTheirConditionNumber) {
  Locators collinear = threeTwoOne();
  collinear[2].first = {0.1, 0.0, 0.0};
  try {
    checkLocatingScheme(collinear);
    FAIL() << "a singular scheme passed";
  } catch (const std::invalid_argument& error) {
    EXPECT_NE(std::string(error.what()).find("singular, condition number beyond 1e+12"), std::string::npos)
        << error.what();
  }
  collinear[2].first = {0.1, 1e-7, 0.0};  // nearly so: the number itself
  try {
    checkLocatingScheme(collinear);
    FAIL() << "an almost singular scheme passed";
  } catch (const std::invalid_argument& error) {
    EXPECT_NE(std::string(error.what()).find("e+06"), std::string::npos) << error.what();
  }
  EXPECT_THROW(checkLocatingScheme(Locators(5, threeTwoOne().front())), std::invalid_argument);
  EXPECT_THROW(checkLocatingScheme(Locators(6, threeTwoOne().front())), std::invalid_argument);
}

TEST(LocatingScheme, conditionDoesNotDependOnTheUnitOfLength) {
  for (const double size : {1e-3, 1.0, 1e3}) {
    Locators locators = threeTwoOne();
    for (auto& locator : locators) locator.first *= size;
    EXPECT_NO_THROW(checkLocatingScheme(locators)) << size;
  }
}

}  // namespace
}  // namespace cable_variation
