// Statistics of measures against stored samples and closed forms; intervals by counting, over 1,000 seeds,
// how often they hold the true figure.
#include <cable_variation/statistics/measure_statistics.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include <cable_variation/math/normal.h>
#include <cable_variation/tolerances/point_set.h>
#include <cable_variation/util/counter_random.h>

namespace cable_variation {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kNone = kNaN;  // no linear prediction

MeasureStatistics statisticsOf(const std::vector<double>& values, const std::optional<double>& lower = {},
                               const std::optional<double>& upper = {}) {
  MeasureAccumulator accumulator(lower, upper);
  for (const double value : values) accumulator.add(value, kNone);
  return accumulator.statistics(0.95);
}

// Mean 5, variance 2, third central moment 3.6, fourth 14.8 (all over n).
const std::vector<double> kValues = {4.0, 4.0, 4.0, 4.0, 4.0, 6.0, 6.0, 4.0, 8.0, 6.0};

TEST(MeasureStatistics, FiguresOfAFewValues) {
  const MeasureStatistics s = statisticsOf(kValues, 3.0, 7.0);
  double m2 = 0.0, m3 = 0.0, m4 = 0.0;
  for (const double value : kValues) {
    m2 += std::pow(value - 5.0, 2) / 10.0;
    m3 += std::pow(value - 5.0, 3) / 10.0;
    m4 += std::pow(value - 5.0, 4) / 10.0;
  }
  EXPECT_EQ(s.count, 10u);
  EXPECT_NEAR(s.mean, 5.0, 1e-14);
  const double sigma = std::sqrt(m2 * 10.0 / 9.0);
  EXPECT_NEAR(s.sigma, sigma, 1e-14);
  EXPECT_NEAR(s.skewness, m3 / std::pow(m2, 1.5), 1e-13);
  EXPECT_NEAR(s.kurtosis, m4 / (m2 * m2), 1e-13);
  EXPECT_EQ(s.min, 4.0);
  EXPECT_EQ(s.max, 8.0);
  EXPECT_EQ(s.range(), 4.0);
  // Student's t of nine degrees of freedom at 97.5 %: 2.262157
  EXPECT_NEAR(s.mean_interval.high - 5.0, 2.262157 * sigma / std::sqrt(10.0), 1e-6);
  ASSERT_TRUE(s.capability);
  EXPECT_NEAR(*s.capability->cp, 4.0 / (6.0 * sigma), 1e-13);
  EXPECT_NEAR(s.capability->cpk, 2.0 / (3.0 * sigma), 1e-13);
  EXPECT_EQ(s.capability->below, 0.0);
  EXPECT_NEAR(s.capability->above, 0.1, 1e-15);
  EXPECT_NEAR(s.capability->above_normal, normalShare(-2.0 / sigma), 1e-14);
  EXPECT_FALSE(s.capability->cpk_quantile);
  // Clopper and Pearson, one of ten: 0.0025286 to 0.4450161, from tables
  EXPECT_NEAR(s.capability->outside_interval.low, 0.0025286, 1e-7);
  EXPECT_NEAR(s.capability->outside_interval.high, 0.4450161, 1e-7);
}

TEST(MeasureStatistics, OneLimitAlone) {
  const MeasureStatistics lower = statisticsOf(kValues, 4.5), upper = statisticsOf(kValues, {}, 9.5);
  EXPECT_FALSE(lower.capability->cp);
  EXPECT_NEAR(lower.capability->cpk, 0.5 / (3.0 * lower.sigma), 1e-13);
  EXPECT_NEAR(lower.capability->below, 0.6, 1e-15);
  EXPECT_NEAR(upper.capability->cpk, 4.5 / (3.0 * upper.sigma), 1e-13);
  EXPECT_EQ(upper.capability->below_normal, 0.0);
  EXPECT_FALSE(statisticsOf(kValues).capability);
}

TEST(MeasureStatistics, SamplesWithoutAValueAreCountedNotDropped) {
  std::vector<double> values = kValues;
  values.insert(values.begin() + 3, {kNaN, kInfinity, kNaN, kInfinity, -kInfinity});
  const MeasureStatistics s = statisticsOf(values, 3.0, 7.0);
  EXPECT_EQ(s.count, 10u);
  EXPECT_EQ(s.missing, 2u);
  EXPECT_EQ(s.infinite, 3u);
  EXPECT_NEAR(s.mean, 5.0, 1e-14);
  EXPECT_NEAR(s.capability->above, 3.0 / 13.0, 1e-15);
  EXPECT_NEAR(s.capability->below, 1.0 / 13.0, 1e-15);
  EXPECT_NEAR(s.capability->outside_at_worst, 6.0 / 15.0, 1e-15);
}

TEST(MeasureStatistics, TooFewValuesGiveNoFigures) {
  const MeasureStatistics none = statisticsOf({}, 0.0, 1.0), one = statisticsOf({2.0}, 0.0, 1.0);
  EXPECT_TRUE(std::isnan(none.mean) && std::isnan(none.sigma) && std::isnan(none.capability->cpk));
  EXPECT_TRUE(std::isnan(none.capability->above));
  EXPECT_EQ(one.mean, 2.0);
  EXPECT_TRUE(std::isnan(one.sigma) && std::isnan(one.mean_interval.low));
  const MeasureStatistics same = statisticsOf(std::vector<double>(100, 0.25), 0.0, 1.0);
  EXPECT_EQ(same.sigma, 0.0);
  EXPECT_EQ(same.capability->cpk, kInfinity);
  EXPECT_TRUE(std::isnan(same.skewness));
  EXPECT_EQ(same.capability->above_normal, 0.0);
}

// Uniform over 0 to 1: quantiles are the shares; Cpk of limits 0.1 and 1.2 over them.
TEST(MeasureStatistics, CapabilityByQuantilesIsRightForAnyDistribution) {
  MeasureAccumulator accumulator(0.1, 1.2);
  constexpr int kCount = 1000000;
  for (int i = 0; i < kCount; ++i) accumulator.add((i + 0.5) / kCount, kNone);
  const MeasureStatistics s = accumulator.statistics(0.95);
  EXPECT_LE(s.percentile_error, 1.0 / 16384);
  for (const Percentile& percentile : s.percentiles) {
    EXPECT_NEAR(percentile.value, percentile.share, s.percentile_error);
  }
  EXPECT_NEAR(*s.capability->cpk_quantile, 0.4 / 0.49865, 1e-3);
  EXPECT_NEAR(*s.capability->cp_quantile, 1.1 / 0.9973, 1e-3);
  EXPECT_NEAR(s.capability->below, 0.1, 1e-9);
  EXPECT_NEAR(s.kurtosis, 1.8, 1e-6);
}

TEST(MeasureStatistics, MergedBlocksGiveTheSameFigures) {
  const CounterRandom random(8, 8);
  MeasureAccumulator once(0.2, 0.9), merged(0.2, 0.9);
  for (std::uint64_t block = 0; block < 40; ++block) {
    MeasureAccumulator part(0.2, 0.9);
    for (std::uint64_t i = 256 * block; i < 256 * (block + 1); ++i) {
      const double value = i % 1000 == 7 ? kNaN : random.uniform(i, 0);
      once.add(value, random.uniform(i, 1));
      part.add(value, random.uniform(i, 1));
    }
    merged.merge(part);
  }
  const MeasureStatistics a = once.statistics(0.95), b = merged.statistics(0.95);
  EXPECT_EQ(a.count, b.count);
  EXPECT_EQ(a.missing, b.missing);
  EXPECT_NEAR(a.mean, b.mean, 1e-14);
  EXPECT_NEAR(a.sigma, b.sigma, 1e-13);
  EXPECT_NEAR(a.kurtosis, b.kurtosis, 1e-12);
  EXPECT_EQ(a.capability->below, b.capability->below);
  for (std::size_t i = 0; i < a.percentiles.size(); ++i) {
    EXPECT_EQ(a.percentiles[i].value, b.percentiles[i].value);
  }
}

// A measure of two normal variables and its closed-form mean and standard deviation.
struct ClosedForm {
  std::string name;
  std::function<double(double, double)> measure;
  double mean, sigma;
  LinearMoments linear;  // of the prediction mean + first * x + second * y
  double first, second;
};

std::vector<ClosedForm> closedForms() {
  const double half = 0.5;
  return {
      {"linear",
       [](double x, double y) { return 3.0 + x - 2.0 * y; },
       3.0,
       std::sqrt(5.0),
       {3.0, std::sqrt(5.0)},
       1.0,
       -2.0},
      // E = 0.1, Var = 1 + 2 0.1²
      {"bent", [](double x, double) { return x + 0.1 * x * x; }, 0.1, std::sqrt(1.02), {0.0, 1.0}, 1.0, 0.0},
      // Var = 1 + 0.3²
      {"product",
       [](double x, double y) { return x + 0.3 * x * y; },
       0.0,
       std::sqrt(1.09),
       {0.0, 1.0},
       1.0,
       0.0},
      // as a similarity: mean √(2/π), variance 1 - 2/π; its one-sided derivative says nothing
      {"kinked",
       [](double x, double) { return std::abs(x); },
       std::sqrt(2.0 / M_PI),
       std::sqrt(1.0 - 2.0 / M_PI),
       {0.0, 1.0},
       1.0,
       0.0},
      // lognormal with σ = 1/2 of the logarithm: mean e^(1/8), variance (e^(1/4) - 1) e^(1/4)
      {"skewed",
       [half](double x, double) { return std::exp(half * x); },
       std::exp(0.125),
       std::sqrt((std::exp(0.25) - 1.0) * std::exp(0.25)),
       {1.0, half},
       half,
       0.0}};
}

MeasureStatistics simulated(const ClosedForm& form, SamplerType type, std::uint64_t count, std::uint64_t seed,
                            const std::optional<double>& lower = {},
                            const std::optional<double>& upper = {}) {
  const PointSet points(type, 2, count, seed);
  MeasureAccumulator accumulator(lower, upper);
  for (std::uint64_t i = 0; i < count; ++i) {
    double u[2];
    points.point(i, u);
    const double x = normalScore(u[0]), y = normalScore(u[1]);
    accumulator.add(form.measure(x, y), form.linear.mean + form.first * x + form.second * y);
  }
  return accumulator.statistics(0.95, form.linear);
}

bool holds(const ConfidenceInterval& interval, double value) {
  return interval.low <= value && value <= interval.high;
}

// The interval of 1,000 repetitions' coverage is 95 % ± 2 %, three standard deviations.
TEST(MeasureStatistics, IntervalsHoldTheTrueFiguresAsOftenAsTheySay) {
  constexpr int kSeeds = 1000;
  for (const ClosedForm& form : closedForms()) {
    const std::uint64_t count = form.name == "skewed" ? 6000 : 1500;  // see ConfidenceInterval
    const double upper = form.mean + 4.0 * form.sigma, cpk = 4.0 / 3.0;
    int mean = 0, sigma = 0, index = 0, controlled_mean = 0, controlled_sigma = 0;
    for (int seed = 0; seed < kSeeds; ++seed) {
      const MeasureStatistics s =
          simulated(form, SamplerType::monte_carlo, count, static_cast<std::uint64_t>(seed), {}, upper);
      mean += holds(s.mean_interval, form.mean);
      sigma += holds(s.sigma_interval, form.sigma);
      index += holds(s.capability->cpk_interval, cpk);
      if (form.name == "linear") continue;  // known without a sample: see below
      ASSERT_TRUE(s.controlled) << s.no_control;
      controlled_mean += holds(s.controlled->mean_interval, form.mean);
      controlled_sigma += holds(s.controlled->sigma_interval, form.sigma);
    }
    EXPECT_NEAR(mean, 950, 20) << form.name;
    EXPECT_NEAR(sigma, 950, 20) << form.name;
    EXPECT_NEAR(index, 950, 20) << form.name;
    if (form.name == "linear") continue;
    EXPECT_NEAR(controlled_mean, 950, 20) << form.name;
    EXPECT_NEAR(controlled_sigma, 950, 20) << form.name;
  }
}

// Of small samples, where a factor that is best for the sample itself would show a bias: the mean of 8,000
// repetitions of 40 samples each is within four of its standard errors.
TEST(MeasureStatistics, ControlledMeanAndVarianceAreUnbiased) {
  constexpr int kSeeds = 8000;
  for (const ClosedForm& form : closedForms()) {
    double mean = 0.0, mean_squares = 0.0, variance = 0.0, variance_squares = 0.0;
    for (int seed = 0; seed < kSeeds; ++seed) {
      const MeasureStatistics s =
          simulated(form, SamplerType::monte_carlo, 40, static_cast<std::uint64_t>(seed));
      if (!s.controlled) continue;
      const double m = s.controlled->mean - form.mean;
      const double v = s.controlled->sigma * s.controlled->sigma - form.sigma * form.sigma;
      mean += m / kSeeds;
      mean_squares += m * m / kSeeds;
      variance += v / kSeeds;
      variance_squares += v * v / kSeeds;
    }
    const double slack = 1e-12;  // the linear one is exact
    EXPECT_LT(std::abs(mean), 4.0 * std::sqrt(mean_squares / kSeeds) + slack) << form.name;
    EXPECT_LT(std::abs(variance), 4.0 * std::sqrt(variance_squares / kSeeds) + slack) << form.name;
  }
}

TEST(MeasureStatistics, ControlSavesAsManySamplesAsItSays) {
  const std::vector<ClosedForm> forms = closedForms();
  for (const ClosedForm& form : {forms[1], forms[2], forms[4]}) {
    constexpr int kSeeds = 400;
    double plain = 0.0, controlled = 0.0, plain_sigma = 0.0, controlled_sigma = 0.0, gain = 0.0,
           sigma_gain = 0.0;
    for (int seed = 0; seed < kSeeds; ++seed) {
      const MeasureStatistics s =
          simulated(form, SamplerType::monte_carlo, 500, static_cast<std::uint64_t>(seed));
      plain += std::pow(s.mean - form.mean, 2);
      controlled += std::pow(s.controlled->mean - form.mean, 2);
      plain_sigma += std::pow(s.sigma - form.sigma, 2);
      controlled_sigma += std::pow(s.controlled->sigma - form.sigma, 2);
      gain += s.controlled->mean_gain / kSeeds;
      sigma_gain += s.controlled->sigma_gain / kSeeds;
    }
    // ratios of two sums of 400 squares: 10 % each
    EXPECT_NEAR(plain / controlled / gain, 1.0, 0.35) << form.name;
    EXPECT_NEAR(plain_sigma / controlled_sigma / sigma_gain, 1.0, 0.35) << form.name;
    EXPECT_GT(gain, form.name == "bent" ? 30.0 : 5.0) << form.name;  // 1.02/0.02 = 51; 1.09/0.09 = 12
  }
}

TEST(MeasureStatistics, ALinearMeasureIsKnownFromItsLinearModel) {
  const ClosedForm form = closedForms().front();
  const MeasureStatistics s = simulated(form, SamplerType::monte_carlo, 100, 1);
  ASSERT_TRUE(s.controlled) << s.no_control;
  EXPECT_NEAR(s.controlled->mean, form.mean, 1e-12);
  EXPECT_NEAR(s.controlled->sigma, form.sigma, 1e-12);
  EXPECT_NEAR(s.controlled->correlation, 1.0, 1e-12);
}

// What rounding leaves of the variance may be negative: the interval stays one, and the gain large.
TEST(MeasureStatistics, ALinearMeasureHasAnIntervalWhateverRoundingLeaves) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    MeasureAccumulator accumulator({}, {});
    const CounterRandom random(seed, 0);
    for (std::uint32_t i = 0; i < 1000; ++i) {
      const double x = 1.2e-3 * normalScore(random.uniform(i, 0));
      accumulator.add(x * 0.7071067811865475, x * 0.7071067811865476);
    }
    const MeasureStatistics s = accumulator.statistics(0.95, LinearMoments{0.0, 1.2e-3 * 0.7071067811865476});
    ASSERT_TRUE(s.controlled) << s.no_control;
    EXPECT_LE(s.controlled->mean_interval.low, s.controlled->mean) << seed;
    EXPECT_GE(s.controlled->mean_interval.high, s.controlled->mean) << seed;
    EXPECT_GT(s.controlled->mean_gain, 1e12) << seed;
  }
}

TEST(MeasureStatistics, WithoutItsGroundsThereIsNoControl) {
  MeasureAccumulator accumulator({}, {});
  for (int i = 0; i < 100; ++i) accumulator.add(std::sin(i), std::sin(i));
  EXPECT_TRUE(accumulator.statistics(0.95, LinearMoments{0.0, 0.7}).controlled);
  EXPECT_FALSE(accumulator.statistics(0.95).controlled);
  EXPECT_FALSE(accumulator.statistics(0.95, LinearMoments{0.0, 0.0}).controlled);
  accumulator.add(kNaN, 0.0);
  const MeasureStatistics s = accumulator.statistics(0.95, LinearMoments{0.0, 0.7});
  EXPECT_FALSE(s.controlled);
  EXPECT_EQ(s.no_control, "1 sample has no value: of the others the linear model's mean is not known");
}

// Points that are stratified lie closer to the true figures than the intervals, which are for independent
// ones.
TEST(MeasureStatistics, IntervalsOfStratifiedSamplersAreOnTheSafeSide) {
  constexpr int kSeeds = 200;
  for (const SamplerType type : {SamplerType::latin_hypercube, SamplerType::sobol}) {
    for (const ClosedForm& form : closedForms()) {
      int mean = 0, sigma = 0;
      for (int seed = 0; seed < kSeeds; ++seed) {
        const MeasureStatistics s = simulated(form, type, 512, static_cast<std::uint64_t>(seed));
        mean += holds(s.mean_interval, form.mean);
        sigma += holds(s.sigma_interval, form.sigma);
      }
      EXPECT_GT(mean, kSeeds * 0.94) << form.name << " " << toString(type);
      EXPECT_GT(sigma, kSeeds * 0.94) << form.name << " " << toString(type);
    }
  }
}

// Normal: σ to ± 1 % at 95 % takes about (1.96/0.01)²/2 = 19,208 samples.
TEST(MeasureStatistics, SampleCountForAWantedErrorOfSigma) {
  const ClosedForm form = closedForms().front();
  MeasureStatistics s = simulated(form, SamplerType::monte_carlo, 4000, 2);
  s.controlled.reset();
  const std::uint64_t needed = samplesNeeded(s, 0.01);
  EXPECT_NEAR(static_cast<double>(needed), 19208.0, 2000.0);
  s = simulated(form, SamplerType::monte_carlo, needed + 1000, 3);
  s.controlled.reset();
  EXPECT_LE(s.sigma_interval.high, 1.0105 * s.sigma);
  EXPECT_EQ(samplesNeeded(statisticsOf(kValues), 0.01), 0u);
  EXPECT_THROW(samplesNeeded(s, 0.0), std::invalid_argument);
  EXPECT_THROW(samplesNeeded(s, 1.0), std::invalid_argument);
  EXPECT_THROW(MeasureAccumulator({}, {}).statistics(1.0), std::invalid_argument);
}

}  // namespace
}  // namespace cable_variation
