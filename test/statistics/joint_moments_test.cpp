// Streamed and merged moments against sums over the stored samples.
#include <cable_variation/statistics/joint_moments.h>

#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include <cable_variation/util/counter_random.h>

namespace cable_variation {
namespace {

struct Pair {
  double x, y;
};

// Skewed, correlated, and far from zero: 1000 ± about 1e-3.
std::vector<Pair> pairs() {
  const CounterRandom random(3, 9);
  std::vector<Pair> result;
  for (std::uint32_t i = 0; i < 1000; ++i) {
    const double a = -std::log(random.uniform(i, 0)), b = random.uniform(i, 1);
    result.push_back({1000.0 + 1e-3 * a, -0.5 + a * b});
  }
  return result;
}

double centralOf(const std::vector<Pair>& samples, int i, int j) {
  long double x = 0.0, y = 0.0, sum = 0.0;
  for (const Pair& p : samples) {
    x += p.x;
    y += p.y;
  }
  const auto n = static_cast<long double>(samples.size());
  for (const Pair& p : samples) sum += std::pow(p.x - x / n, i) * std::pow(p.y - y / n, j);
  return static_cast<double>(sum / n);
}

void expectMomentsOf(const std::vector<Pair>& samples, const JointMoments& moments) {
  ASSERT_EQ(moments.count(), samples.size());
  for (int i = 0; i <= 4; ++i) {
    for (int j = 0; i + j <= 4; ++j) {
      const double expected = centralOf(samples, i, j);
      // x is known to 1e-13 of 1000, which is 1e-10 of its deviations
      EXPECT_NEAR(moments.central(i, j), expected, 1e-9 * std::abs(expected) + 1e-9 * std::pow(1e-3, i))
          << i << " " << j;
    }
  }
}

TEST(JointMoments, StreamedMomentsAreThoseOfTheSamples) {
  JointMoments moments;
  for (const Pair& p : pairs()) moments.add(p.x, p.y);
  expectMomentsOf(pairs(), moments);
}

TEST(JointMoments, MergedMomentsAreThoseOfAllSamples) {
  const std::vector<Pair> samples = pairs();
  JointMoments all;
  std::size_t next = 0;
  for (const std::size_t size : {0u, 1u, 500u, 0u, 2u, 497u}) {
    JointMoments part;
    for (std::size_t i = 0; i < size; ++i, ++next) part.add(samples[next].x, samples[next].y);
    all.merge(part);
  }
  expectMomentsOf(samples, all);
}

}  // namespace
}  // namespace cable_variation
