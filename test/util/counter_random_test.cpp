// The generator against the known answers that its authors published, and simple statistics.
#include <cable_variation/util/counter_random.h>

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

namespace cable_variation {
namespace {

using Words = std::array<std::uint32_t, 4>;

// kat_vectors of the Random123 library, philox4x32 10.
TEST(CounterRandom, PhiloxGivesThePublishedAnswers) {
  constexpr std::uint32_t kOnes = 0xffffffff;
  EXPECT_EQ(philox({0, 0, 0, 0}, {0, 0}), (Words{0x6627e8d5, 0xe169c58d, 0xbc57ac4c, 0x9b00dbd8}));
  EXPECT_EQ(philox({kOnes, kOnes, kOnes, kOnes}, {kOnes, kOnes}),
            (Words{0x408f276d, 0x41c83b0e, 0xa20bc7c6, 0x6d5451fd}));
  EXPECT_EQ(philox({0x243f6a88, 0x85a308d3, 0x13198a2e, 0x03707344}, {0xa4093822, 0x299f31d0}),
            (Words{0xd16cfe09, 0x94fdcceb, 0x5001e420, 0x24126ea1}));
}

TEST(CounterRandom, AUniformNumberIsNeverAnEnd) {
  EXPECT_GT(openUnit(0), 0.0);
  EXPECT_LT(openUnit(std::numeric_limits<std::uint64_t>::max()), 1.0);
}

TEST(CounterRandom, NumbersAreUniformAndUncorrelatedWithTheirNeighbours) {
  constexpr int kCount = 100000;
  const CounterRandom random(7, 1);
  double sum = 0.0, squares = 0.0, next_row = 0.0, next_column = 0.0;
  for (std::uint32_t i = 0; i < kCount; ++i) {
    const double x = random.uniform(i, 3) - 0.5;
    sum += x;
    squares += x * x;
    next_row += x * (random.uniform(i + 1, 3) - 0.5);
    next_column += x * (random.uniform(i, 4) - 0.5);
  }
  // five standard errors; variance 1/12, of the square 1/180, of the products 1/144
  const double root = std::sqrt(static_cast<double>(kCount));
  EXPECT_NEAR(sum / kCount, 0.0, 5.0 * std::sqrt(1.0 / 12.0) / root);
  EXPECT_NEAR(squares / kCount, 1.0 / 12.0, 5.0 * std::sqrt(1.0 / 180.0) / root);
  EXPECT_NEAR(next_row / kCount, 0.0, 5.0 / 12.0 / root);
  EXPECT_NEAR(next_column / kCount, 0.0, 5.0 / 12.0 / root);
}

TEST(CounterRandom, SeedStreamRowAndColumnAllTellNumbersApart) {
  const double x = CounterRandom(1, 1).uniform(5, 2);
  EXPECT_EQ(CounterRandom(1, 1).uniform(5, 2), x);
  EXPECT_NE(CounterRandom(2, 1).uniform(5, 2), x);
  EXPECT_NE(CounterRandom(1ull + (1ull << 32), 1).uniform(5, 2), x);
  EXPECT_NE(CounterRandom(1, 2).uniform(5, 2), x);
  EXPECT_NE(CounterRandom(1, 1).uniform(5 + (1ull << 32), 2), x);
  EXPECT_NE(CounterRandom(1, 1).uniform(5, 3), x);
}

TEST(CounterRandom, ARowGivesItsNumbersColumnByColumn) {
  const CounterRandom random(1, 1);
  RandomRow row(random, 5);
  for (std::uint32_t column = 0; column < 4; ++column) EXPECT_EQ(row.uniform(), random.uniform(5, column));
}

}  // namespace
}  // namespace cable_variation
