#include <cable_variation/scene/measure.h>

#include <limits>

#include <gtest/gtest.h>

#include <cable_variation/scene/severity.h>

namespace cable_variation {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

TEST(MeasureLimits, theLimitItselfKeepsIt) {
  Measure gap;
  gap.lower = 0.005;
  gap.upper = 0.01;
  for (const double value : {0.005, 0.007, 0.01}) {
    EXPECT_TRUE(withinLimits(gap, value)) << value;
    EXPECT_FALSE(beyondLimits(gap, value)) << value;
  }
  for (const double value : {0.004, 0.011}) {
    EXPECT_FALSE(withinLimits(gap, value)) << value;
    EXPECT_TRUE(beyondLimits(gap, value)) << value;
  }
}

TEST(MeasureLimits, oneAloneIsLookedAtAlone) {
  Measure gap;
  gap.lower = 0.005;
  EXPECT_TRUE(withinLimits(gap, 1.0));
  EXPECT_TRUE(beyondLimits(gap, -1.0));
  gap.lower.reset();
  gap.upper = 0.01;
  EXPECT_TRUE(withinLimits(gap, -1.0));
  EXPECT_TRUE(beyondLimits(gap, 1.0));
}

TEST(MeasureLimits, aMissingValueIsNeitherWithinNorBeyondThem) {
  Measure gap;
  EXPECT_TRUE(withinLimits(gap, kNan)) << "it has none";
  gap.lower = 0.005;
  EXPECT_FALSE(withinLimits(gap, kNan));
  EXPECT_FALSE(beyondLimits(gap, kNan));
}

TEST(MeasureLimits, anythingIsWorseThanWhatIsNotANumber) {
  Measure gap;
  gap.lower = 1.0;
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  const double none = kNan;
  EXPECT_TRUE(isWorse(gap, 0.0, 1.0, 2.0));
  EXPECT_FALSE(isWorse(gap, 0.0, 2.0, 1.0));
  EXPECT_TRUE(isWorse(gap, 0.0, 5.0, kInfinity));
  EXPECT_FALSE(isWorse(gap, 0.0, kInfinity, kInfinity));
  EXPECT_TRUE(isWorse(gap, 0.0, kInfinity, none));
  EXPECT_FALSE(isWorse(gap, 0.0, none, kInfinity));
  EXPECT_FALSE(isWorse(gap, 0.0, none, none));
}

}  // namespace
}  // namespace cable_variation
