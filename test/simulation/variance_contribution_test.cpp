// Contributions of variables to variance, against closed forms and a direct least-squares fit.
#include <cable_variation/simulation/variance_contribution.h>

#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include <Eigen/QR>
#include <gtest/gtest.h>

#include <cable_variation/math/normal.h>
#include <cable_variation/util/counter_random.h>

namespace cable_variation {
namespace {

std::vector<double> normalEdges(double sigma) {
  DesignVariable variable;
  variable.lower = -3.0 * sigma;
  variable.upper = 3.0 * sigma;
  return VarianceContributor::binEdges(*makeDistribution(variable));
}

struct Sample {
  std::array<double, 2> deviations;
  std::vector<double> values;
};

// x of sigma 1, y of sigma 1/2: a linear measure, a kinked one, and a product.
std::vector<Sample> samples(std::uint32_t count, double correlation = 0.0) {
  const CounterRandom random(4, 4);
  std::vector<Sample> result;
  for (std::uint32_t i = 0; i < count; ++i) {
    const double a = normalScore(random.uniform(i, 0)), b = normalScore(random.uniform(i, 1));
    const double x = a, y = 0.5 * (correlation * a + std::sqrt(1.0 - correlation * correlation) * b);
    result.push_back({{x, y}, {100.0 + 2.0 * x - 3.0 * y, std::abs(x) + y, x * y}});
  }
  return result;
}

VarianceContributor contributorOf(const std::vector<Sample>& samples) {
  VarianceContributor contributor({normalEdges(1.0), normalEdges(0.5)}, 3);
  for (const Sample& sample : samples) contributor.add(sample.deviations.data(), sample.values.data());
  return contributor;
}

TEST(VarianceContribution, RegressionIsTheLeastSquaresFit) {
  const std::vector<Sample> all = samples(500, 0.6);
  const VarianceContributions found = contributorOf(all).contributions();
  Eigen::MatrixXd rows(500, 3), values(500, 3);
  for (Eigen::Index i = 0; i < 500; ++i) {
    const Sample& sample = all[static_cast<std::size_t>(i)];
    rows.row(i) << 1.0, sample.deviations[0], sample.deviations[1];
    values.row(i) << sample.values[0], sample.values[1], sample.values[2];
  }
  const Eigen::MatrixXd fit = rows.householderQr().solve(values);
  const Eigen::MatrixXd residual = values - rows * fit;
  for (Eigen::Index m = 0; m < 3; ++m) {
    const double total = (values.col(m).array() - values.col(m).mean()).square().sum();
    const double r_squared = 1.0 - residual.col(m).squaredNorm() / total;
    EXPECT_NEAR(found.r_squared[m], r_squared, 1e-10);
    EXPECT_NEAR(found.regression_share.row(m).sum(), r_squared, 1e-10);
    for (Eigen::Index v = 0; v < 2; ++v) {
      EXPECT_NEAR(found.slope(m, v), fit(v + 1, m), 1e-10);
      const double spread =
          std::sqrt((rows.col(v + 1).array() - rows.col(v + 1).mean()).square().sum() / total);
      EXPECT_NEAR(found.standardised(m, v), fit(v + 1, m) * spread, 1e-10);
    }
  }
}

// Var(2x - 3y) = 4 + 9/4; |x| has 1 - 2/π and y 1/4; of a product neither alone has any.
TEST(VarianceContribution, FirstOrderIndicesAreThoseOfTheClosedForms) {
  const VarianceContributions found = contributorOf(samples(200000)).contributions();
  EXPECT_EQ(found.bins, 64u);
  const double kink = 1.0 - 2.0 / M_PI;
  const double expected[3][2] = {
      {4.0 / 6.25, 2.25 / 6.25}, {kink / (kink + 0.25), 0.25 / (kink + 0.25)}, {0.0, 0.0}};
  for (Eigen::Index m = 0; m < 3; ++m) {
    for (Eigen::Index v = 0; v < 2; ++v) {
      // bins: a hundredth of itself for a linear effect, three for |x|; noise: √128/200,000 and correlated
      // terms
      EXPECT_NEAR(found.first_order(m, v), expected[m][v], 0.03 * expected[m][v] + 0.004) << m << " " << v;
    }
  }
  // what the linear model does not see
  EXPECT_LT(found.regression_share(1, 0), 0.01);
}

TEST(VarianceContribution, FewSamplesHaveNoBiasByChance) {
  double sum = 0.0;
  constexpr std::uint32_t kRepetitions = 400, kCount = 150;
  const CounterRandom random(9, 9);
  for (std::uint32_t r = 0; r < kRepetitions; ++r) {
    VarianceContributor contributor({normalEdges(1.0)}, 1);
    for (std::uint32_t i = 0; i < kCount; ++i) {
      const double x = normalScore(random.uniform(i, 2 * r)), value = random.uniform(i, 2 * r + 1);
      contributor.add(&x, &value);
    }
    const VarianceContributions found = contributor.contributions();
    EXPECT_EQ(found.bins, 8u);
    sum += found.first_order(0, 0);
  }
  // standard error of one: √(2 7)/150
  EXPECT_NEAR(sum / kRepetitions, 0.0, 4.0 * std::sqrt(14.0) / kCount / std::sqrt(kRepetitions));
}

TEST(VarianceContribution, MergedPartsAreTheWhole) {
  const std::vector<Sample> all = samples(3000, 0.3);
  const VarianceContributions once = contributorOf(all).contributions();
  VarianceContributor merged = contributorOf({});
  for (std::size_t begin = 0; begin < all.size(); begin += 500) {
    const auto from = all.begin() + static_cast<std::ptrdiff_t>(begin);
    merged.merge(contributorOf({from, from + 500}));
  }
  const VarianceContributions parts = merged.contributions();
  EXPECT_EQ(parts.count, once.count);
  EXPECT_LT((parts.slope - once.slope).norm(), 1e-12);
  EXPECT_LT((parts.first_order - once.first_order).norm(), 1e-12);
}

TEST(VarianceContribution, SamplesWithoutValuesAreCounted) {
  VarianceContributor contributor = contributorOf(samples(100));
  const double deviations[2] = {0.0, 0.0};
  const double values[3] = {1.0, std::numeric_limits<double>::infinity(), 0.0};
  contributor.add(deviations, values);
  contributor.leaveOut();
  EXPECT_EQ(contributor.contributions().count, 100u);
  EXPECT_EQ(contributor.contributions().left_out, 2u);
}

TEST(VarianceContribution, TooFewSamplesAndMeasuresThatDoNotVary) {
  EXPECT_EQ(contributorOf(samples(4)).contributions().slope.size(), 0);
  EXPECT_EQ(contributorOf(samples(31)).contributions().first_order.size(), 0);
  VarianceContributor contributor({normalEdges(1.0)}, 1);
  const double value = 5.0;
  for (int i = 0; i < 100; ++i) {
    const double x = std::sin(i);
    contributor.add(&x, &value);
  }
  const VarianceContributions found = contributor.contributions();
  EXPECT_EQ(found.slope(0, 0), 0.0);
  EXPECT_TRUE(std::isnan(found.r_squared[0]));
  EXPECT_TRUE(std::isnan(found.first_order(0, 0)));
}

TEST(VarianceContribution, ADiscreteVariableFillsFewBins) {
  DesignVariable variable;
  variable.distribution = "discrete";
  variable.distribution_values = {-1.0, 1.0, 2.0};
  variable.distribution_weights = {0.3, 0.3, 0.4};
  const auto distribution = makeDistribution(variable);
  VarianceContributor contributor({VarianceContributor::binEdges(*distribution)}, 1);
  const CounterRandom random(2, 2);
  for (std::uint32_t i = 0; i < 20000; ++i) {
    const double x = distribution->quantile(random.uniform(i, 0));
    // x² varies by 1.5² 0.4 0.6 4 = 2.16, the rest by 2.16
    const double value = x * x + std::sqrt(2.16) * normalScore(random.uniform(i, 1));
    contributor.add(&x, &value);
  }
  EXPECT_NEAR(contributor.contributions().first_order(0, 0), 0.5, 0.02);
}

}  // namespace
}  // namespace cable_variation
