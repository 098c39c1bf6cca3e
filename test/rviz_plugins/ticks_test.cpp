// Numbers beside a colour bar: round, inside, few, and the bounds themselves.
#include <rviz_plugins/ticks.h>

#include <cmath>

#include <gtest/gtest.h>

namespace cable_variation_rviz {
namespace {

TEST(Ticks, AreTheBoundsAndRoundValuesBetween) {
  const std::vector<Tick> found = ticks(0.0, 4.17, 5);
  const std::vector<std::pair<double, std::string>> expected = {
      {0.0, "0"}, {1.0, "1"}, {2.0, "2"}, {3.0, "3"}, {4.17, "4.17"}};  // 4 is too near 4.17
  ASSERT_EQ(found.size(), expected.size());
  for (std::size_t i = 0; i < expected.size(); ++i) {
    EXPECT_DOUBLE_EQ(found[i].value, expected[i].first);
    EXPECT_EQ(found[i].label.toStdString(), expected[i].second);
  }
}

TEST(Ticks, AreLabelledToTheirStep) {
  const std::vector<Tick> found = ticks(-0.05, 0.22, 5);
  ASSERT_EQ(found.size(), 4u);
  EXPECT_EQ(found[1].label.toStdString(), "0.0");
  EXPECT_EQ(found[2].label.toStdString(), "0.1");
}

TEST(Ticks, OfNoRangeAreOne) {
  ASSERT_EQ(ticks(2.5, 2.5, 4).size(), 1u);
  EXPECT_EQ(ticks(2.5, 2.5, 4)[0].label.toStdString(), "2.5");
}

TEST(Ticks, AreInOrderInsideAndFewAtEverySize) {
  for (const double size : {1e-12, 3e-7, 0.02, 1.0, 9.99, 12345.0, 7e15}) {
    for (const double start : {-1.3, -0.5, 0.0, 2.2, 1000.0}) {
      const double low = start * size, high = low + size;
      const std::vector<Tick> found = ticks(low, high, 5);
      ASSERT_GE(found.size(), 2u);
      ASSERT_LE(found.size(), 2u + 5u);
      for (std::size_t i = 1; i < found.size(); ++i) EXPECT_GT(found[i].value, found[i - 1].value);
      EXPECT_EQ(found.front().value, low);
      EXPECT_EQ(found.back().value, high);
    }
  }
}

}  // namespace
}  // namespace cable_variation_rviz
