// Quantiles and histograms of streams against the sorted values.
#include <cable_variation/statistics/sample_histogram.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

#include <gtest/gtest.h>

#include <cable_variation/math/normal.h>
#include <cable_variation/tolerances/sample_distribution.h>
#include <cable_variation/util/counter_random.h>

namespace cable_variation {
namespace {

const std::vector<double> kShares = {0.0, 1e-4, 0.00135, 0.05, 0.3, 0.5, 0.7772, 0.99, 0.99865, 1.0};

std::vector<double> normalValues(std::size_t count, double mean, double sigma) {
  const CounterRandom random(1, 2);
  std::vector<double> values;
  for (std::size_t i = 0; i < count; ++i) values.push_back(mean + sigma * normalScore(random.uniform(i, 0)));
  return values;
}

SampleHistogram histogramOf(const std::vector<double>& values) {
  SampleHistogram histogram;
  for (const double value : values) histogram.add(value);
  return histogram;
}

std::vector<double> hazen(const std::vector<double>& values) {
  const EmpiricalDistribution distribution(values);
  std::vector<double> quantiles;
  for (const double share : kShares) quantiles.push_back(distribution.quantile(share));
  return quantiles;
}

void expectNear(const std::vector<double>& found, const std::vector<double>& expected, double error) {
  ASSERT_EQ(found.size(), expected.size());
  for (std::size_t i = 0; i < found.size(); ++i) EXPECT_NEAR(found[i], expected[i], error) << kShares[i];
}

TEST(SampleHistogram, FewValuesAreExact) {
  for (const std::size_t count : {2u, 3u, 100u, 4096u}) {
    const std::vector<double> values = normalValues(count, 5.0, 2.0);
    const SampleHistogram histogram = histogramOf(values);
    EXPECT_EQ(histogram.error(), 0.0);
    expectNear(histogram.quantiles(kShares), hazen(values), 1e-12);
  }
}

TEST(SampleHistogram, ManyValuesAreWithinTheStatedError) {
  struct Case {
    std::vector<double> values;
    double largest_error;  // a 16,384th of the range, or more
  };
  std::vector<double> two_heaps = normalValues(20000, 0.0, 1.0);
  for (std::size_t i = 0; i < two_heaps.size() / 2; ++i) two_heaps[i] += 50.0;
  std::vector<double> late_outlier = normalValues(20000, 0.02, 1e-3);
  late_outlier.push_back(-7.0);
  const std::vector<Case> cases = {{normalValues(50000, 0.0, 1.0), 10.0 / 16384},
                                   {normalValues(50000, 1e6, 1e-3), 0.01 / 16384},
                                   {normalValues(50000, -3e-9, 1e-9), 1e-8 / 16384},
                                   {two_heaps, 60.0 / 16384},
                                   {late_outlier, 8.0 / 16384}};
  for (const Case& c : cases) {
    const SampleHistogram histogram = histogramOf(c.values);
    EXPECT_GT(histogram.error(), 0.0);
    EXPECT_LE(histogram.error(), c.largest_error);
    // near 1e6 doubles are 1e-10 apart
    const double rounding = 4e-16 * std::max(std::abs(histogram.min()), std::abs(histogram.max()));
    expectNear(histogram.quantiles(kShares), hazen(c.values), histogram.error() + rounding);
  }
}

TEST(SampleHistogram, OrderAndPartsDoNotMatter) {
  std::vector<double> values = normalValues(30000, 1.0, 1.0);
  values[29000] = 400.0;
  const SampleHistogram once = histogramOf(values);
  std::vector<double> reversed(values.rbegin(), values.rend());
  EXPECT_EQ(histogramOf(reversed).quantiles(kShares), once.quantiles(kShares));
  SampleHistogram merged;
  std::size_t next = 0;
  for (const std::size_t size : {10u, 9000u, 3u, 12000u, 0u, 8987u}) {
    SampleHistogram part;
    for (std::size_t i = 0; i < size; ++i) part.add(values[next++]);
    merged.merge(part);
  }
  EXPECT_EQ(merged.count(), once.count());
  EXPECT_EQ(merged.error(), once.error());
  EXPECT_EQ(merged.quantiles(kShares), once.quantiles(kShares));
  EXPECT_EQ(merged.histogram(48).counts, once.histogram(48).counts);
}

TEST(SampleHistogram, BinsCountTheValuesWithinThem) {
  for (const std::size_t count : {1000u, 20000u}) {
    const std::vector<double> values = normalValues(count, 3.0, 0.7);
    const Histogram bins = histogramOf(values).histogram(40);
    EXPECT_GT(bins.counts.size(), 20u);
    EXPECT_LE(bins.counts.size(), 40u);
    for (std::size_t b = 0; b < bins.counts.size(); ++b) {
      const double low = bins.low + bins.width * static_cast<double>(b), high = low + bins.width;
      const auto within = std::count_if(values.begin(), values.end(), [&](double value) {
        // the last one has its upper edge, where the largest of a few values is
        return value >= low && (value < high || b + 1 == bins.counts.size());
      });
      EXPECT_NEAR(static_cast<double>(bins.counts[b]), static_cast<double>(within),
                  count == 1000 ? 1.0 : 0.0);
    }
    EXPECT_EQ(std::accumulate(bins.counts.begin(), bins.counts.end(), std::uint64_t{0}), count);
  }
}

TEST(SampleHistogram, ValuesThatAreAllAlike) {
  for (const double value : {0.0, -0.031, 1e300}) {
    const SampleHistogram histogram = histogramOf(std::vector<double>(5000, value));
    for (const double quantile : histogram.quantiles(kShares)) EXPECT_EQ(quantile, value);
    EXPECT_EQ(histogram.histogram(48).counts, std::vector<std::uint64_t>{5000});
  }
  EXPECT_TRUE(SampleHistogram().histogram(48).counts.empty());
  EXPECT_TRUE(std::isnan(SampleHistogram().quantiles({0.5})[0]));
}

TEST(SampleHistogram, HugeAndTinyValuesTogether) {
  std::vector<double> values(5000, 1e-300);
  values.push_back(-1e308);
  values.push_back(1e308);
  const SampleHistogram histogram = histogramOf(values);
  EXPECT_EQ(histogram.min(), -1e308);
  EXPECT_EQ(histogram.max(), 1e308);
  EXPECT_NEAR(histogram.quantiles({0.5})[0], 0.0, histogram.error());
}

}  // namespace
}  // namespace cable_variation
