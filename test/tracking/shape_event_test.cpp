// Limits that are broken and kept again, told as a shape changes.
#include <cable_variation/tracking/shape_event.h>

#include <cmath>
#include <vector>

#include <gtest/gtest.h>

namespace cable_variation {
namespace {

using Kind = ShapeEvent::Kind;

Measure atLeast(double lower) {
  Measure measure;
  measure.name = "gap";
  measure.unit = "m";
  measure.lower = lower;
  return measure;
}

std::vector<ShapeEvent> told(LimitWatch& watch, const Measure& measure, double value) {
  MeasureValue measured;
  measured.value = value;
  return watch.compare({measure}, {measured});
}

TEST(LimitWatch, TellsWhatIsBrokenAndKeptAgain) {
  const Measure gap = atLeast(0.01);
  LimitWatch watch;
  EXPECT_TRUE(told(watch, gap, 0.02).empty());
  ASSERT_EQ(told(watch, gap, 0.005).size(), 1U);
  EXPECT_TRUE(told(watch, gap, 0.004).empty());
  const std::vector<ShapeEvent> kept = told(watch, gap, 0.03);
  ASSERT_EQ(kept.size(), 1U);
  EXPECT_EQ(kept[0].kind, Kind::limit_kept);
  EXPECT_EQ(kept[0].from_value, 0.004);
}

// A value that is not a number neither breaks a limit nor keeps it: what was known of it stands.
TEST(LimitWatch, WhatIsNotKnownIsNeitherBrokenNorKept) {
  const Measure gap = atLeast(0.01);
  for (const double known : {0.02, 0.005}) {
    LimitWatch watch;
    EXPECT_TRUE(told(watch, gap, std::nan("")).empty());
    const std::size_t first = told(watch, gap, known).size();
    EXPECT_EQ(first, known < 0.01 ? 1U : 0U);
    EXPECT_TRUE(told(watch, gap, std::nan("")).empty());
    EXPECT_TRUE(told(watch, gap, known).empty());
    EXPECT_EQ(told(watch, gap, 0.025 - known).size(), 1U);
  }
}

}  // namespace
}  // namespace cable_variation
