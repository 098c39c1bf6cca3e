// Distributions of any parameters, drawn at random: cdf against the closed forms of mean and standard
// deviation by quadrature, quantile against cdf, and correlated samples against the correlation that was
// asked for.
#include <cable_variation/tolerances/distribution.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <set>
#include <stdexcept>
#include <string>
#include <vector>

#include <boost/math/quadrature/gauss.hpp>
#include <gtest/gtest.h>

#include <cable_variation/tolerances/sampler.h>
#include <cable_variation/util/counter_random.h>

namespace cable_variation {
namespace {

class Random {
 public:
  explicit Random(std::uint64_t row) : row_(CounterRandom(2026, 0), row) {}
  double between(double low, double high) { return low + (high - low) * row_.uniform(); }
  double ofSize(double low, double high) { return low * std::pow(high / low, row_.uniform()); }
  std::size_t below(std::size_t count) {
    return static_cast<std::size_t>(row_.uniform() * static_cast<double>(count));
  }
  bool chance(double share) { return row_.uniform() < share; }

 private:
  RandomRow row_;
};

constexpr std::size_t kKinds = 9;

// Limits of sizes that scenes have: micrometres to metres, about nominal or to one side of it.
DesignVariable anyVariable(Random& random, std::size_t kind) {
  DesignVariable variable;
  variable.name = "x";
  const double width = random.ofSize(1e-6, 1.0);
  variable.lower = random.chance(0.2) ? 0.0 : -width * random.between(0.1, 0.9);
  variable.upper = variable.lower + width;
  auto& parameters = variable.distribution_parameters;
  switch (kind) {
    case 0:
      variable.distribution = "beta";
      parameters = {{"alpha", random.ofSize(1e-3, 1e5)}, {"beta", random.ofSize(1e-3, 1e5)}};
      break;
    case 1:
      variable.distribution = "weibull";
      parameters = {{"shape", random.ofSize(0.5, 50.0)}};
      break;
    case 2:
      variable.distribution = "skew_normal";
      parameters = {{"shape", random.ofSize(1e-3, 1e3) * (random.chance(0.5) ? 1.0 : -1.0)}};
      break;
    case 3:
      variable.distribution = "triangular";
      parameters = {{"mode", random.chance(0.3)   ? variable.lower
                             : random.chance(0.5) ? variable.upper
                                                  : random.between(variable.lower, variable.upper)}};
      break;
    case 4:
      variable.distribution = "truncated_normal";
      parameters = {{"sigma", random.ofSize(1e-9, 100.0)}};
      break;
    case 5:
      variable.distribution = "trapezoidal";
      parameters = {{"plateau", random.chance(0.2)   ? 1.0
                                : random.chance(0.2) ? 0.0
                                                     : random.between(0.0, 1.0)}};
      break;
    case 6:
      variable.distribution = "normal";
      parameters = {{"sigma", random.ofSize(1e-3, 100.0)}};
      break;
    case 7: {
      variable.distribution = "empirical";
      const std::size_t count = 2 + random.below(40);
      for (std::size_t i = 0; i < count; ++i) {
        const bool tie = i > 1 && random.chance(0.4);
        variable.distribution_values.push_back(tie ? variable.distribution_values[random.below(i)]
                                                   : random.between(variable.lower, variable.upper));
      }
      break;
    }
    default: {
      variable.distribution = "discrete";
      const std::size_t count = 2 + random.below(6);
      double sum = 0.0;
      for (std::size_t i = 0; i < count; ++i) {
        variable.distribution_values.push_back(random.between(variable.lower, variable.upper));
        variable.distribution_weights.push_back(random.ofSize(0.01, 1.0));
        sum += variable.distribution_weights.back();
      }
      for (double& weight : variable.distribution_weights) weight /= sum;
    }
  }
  return variable;
}

std::string nameOf(const DesignVariable& variable) {
  std::string name = variable.distribution + " from " + std::to_string(variable.lower) + " to " +
                     std::to_string(variable.upper);
  for (const auto& [key, value] : variable.distribution_parameters)
    name += ", " + key + " " + std::to_string(value);
  return name;
}

DesignVariable betaOf(double alpha, double beta) {
  DesignVariable variable;
  variable.name = "x";
  variable.lower = 0.0;
  variable.upper = 1.0;
  variable.distribution = "beta";
  variable.distribution_parameters = {{"alpha", alpha}, {"beta", beta}};
  return variable;
}

struct Moments {
  double mean, sigma;
};

// By parts of the cdf F: about c, E[x - c] = ∫_c (1 - F) - ∫^c F and E[(x - c)²] = 2 ∫_c (x - c)(1 - F) -
// 2 ∫^c (x - c) F, by Gauss's rule between places that lie ever closer to c and to both limits, where a
// density may be infinite.
Moments momentsOf(const Distribution& distribution, double low, double high, double centre, double size) {
  std::set<double> places{low, high};
  const auto place = [&](double x) {
    if (x > low && x < high) places.insert(x);
  };
  for (double distance = 1e-3 * size; distance < 60.0 * size; distance *= 1.1) {
    place(centre - distance);
    place(centre + distance);
  }
  for (double distance = high - low; distance > 1e-12 * (high - low); distance *= 0.6) {
    place(low + distance);
    place(high - distance);
  }
  place(centre);
  double first = 0.0, second = 0.0;
  for (auto to = std::next(places.begin()); to != places.end(); ++to) {
    const double from = *std::prev(to);
    const double side = 0.5 * (from + *to) < centre ? -1.0 : 1.0;
    const auto beyond = [&](double x) {
      return side > 0.0 ? 1.0 - distribution.cdf(x) : distribution.cdf(x);
    };
    using Quadrature = boost::math::quadrature::gauss<double, 10>;
    first += side * Quadrature::integrate(beyond, from, *to);
    second +=
        2.0 * Quadrature::integrate([&](double x) { return std::abs(x - centre) * beyond(x); }, from, *to);
  }
  return {centre + first, std::sqrt(second - first * first)};
}

TEST(DistributionFamily, MeanAndStandardDeviationAreThoseOfTheCdf) {
  for (std::uint64_t row = 0; row < 360; ++row) {
    Random random(row);
    const std::size_t kind = row % kKinds;
    if (kind >= 7) continue;  // steps: below, by sums
    const DesignVariable variable = anyVariable(random, kind);
    const auto distribution = makeDistribution(variable);
    const double sigma = distribution->standardDeviation();
    ASSERT_GT(sigma, 0.0) << nameOf(variable);
    const double mean = distribution->mean();
    const bool below = kind == 2 || kind == 6, above = below || kind == 1;  // it goes beyond its tolerance
    const Moments found = momentsOf(*distribution, below ? mean - 60.0 * sigma : variable.lower,
                                    above ? mean + 60.0 * sigma : variable.upper, mean, sigma);
    // a skewed one all but breaks off at one side, and an exponential tail goes beyond sixty σ
    EXPECT_NEAR(found.mean, mean, (kind == 2 ? 1e-5 : 1e-6) * sigma) << nameOf(variable);
    EXPECT_NEAR(found.sigma, sigma, 2e-5 * sigma) << nameOf(variable);
  }
}

// The quantile is where the cdf goes through the probability: below it on one side, above on the other, as
// near as doubles lie there.
TEST(DistributionFamily, QuantileIsWhereTheCdfGoesThrough) {
  for (std::uint64_t row = 0; row < 720; ++row) {
    Random random(row);
    const DesignVariable variable = anyVariable(random, row % kKinds);
    const auto distribution = makeDistribution(variable);
    const double sigma = distribution->standardDeviation();
    double last = -std::numeric_limits<double>::infinity();
    for (const double p : {1e-9, 1e-4, 0.01, 0.2, 0.5, random.between(0.5, 0.6), 0.8, 0.99, 1.0 - 1e-6}) {
      const double x = distribution->quantile(p);
      ASSERT_TRUE(std::isfinite(x)) << nameOf(variable) << " at " << p;
      EXPECT_GE(x, last - 1e-14 * sigma) << nameOf(variable) << " at " << p;
      last = x;
      const double near = 1e-9 * sigma + 1e-15 * std::max(std::abs(variable.lower), std::abs(variable.upper));
      EXPECT_LE(distribution->cdf(x - near), p * (1.0 + 1e-9) + 1e-15) << nameOf(variable) << " at " << p;
      EXPECT_GE(distribution->cdf(x + near), p * (1.0 - 1e-9) - 1e-15) << nameOf(variable) << " at " << p;
    }
  }
}

TEST(DistributionFamily, QuantileOfTheCdfIsWhereItBegan) {
  for (std::uint64_t row = 0; row < 720; ++row) {
    Random random(1000 + row);
    const DesignVariable variable = anyVariable(random, row % kKinds);
    const auto distribution = makeDistribution(variable);
    for (int i = 0; i < 5; ++i) {
      const double x = distribution->quantile(random.between(0.02, 0.98));
      const double p = distribution->cdf(x);
      if (p <= 0.0 || p >= 1.0) continue;  // at a limit
      EXPECT_NEAR(distribution->quantile(p), x, 1e-9 * distribution->standardDeviation()) << nameOf(variable);
    }
  }
}

TEST(DistributionFamily, BetaClosedForms) {
  for (const double p : {1e-8, 0.003, 0.2, 0.5, 0.9, 0.9999}) {
    for (const double power : {0.1, 0.5, 1.0, 2.0, 50.0, 1e3}) {
      // (a, 1): u^a; (1, b): 1 - (1 - u)^b
      EXPECT_NEAR(makeDistribution(betaOf(power, 1.0))->quantile(p), std::pow(p, 1.0 / power), 1e-13)
          << power;
      EXPECT_NEAR(makeDistribution(betaOf(1.0, power))->quantile(p), -std::expm1(std::log1p(-p) / power),
                  1e-13)
          << power;
    }
    // (½, ½): arcsine
    const double sine = std::sin(0.5 * M_PI * p);
    EXPECT_NEAR(makeDistribution(betaOf(0.5, 0.5))->quantile(p), sine * sine, 1e-13);
    // of a thousand each normal, but for its kurtosis of -6/2003: moves a quantile by some 1e-3 σ
    const auto bell = makeDistribution(betaOf(1e3, 1e3));
    EXPECT_NEAR(bell->standardDeviation(), 0.5 / std::sqrt(2001.0), 1e-15);
  }
  for (const auto& [alpha, beta] : std::vector<std::pair<double, double>>{
           {5, 5}, {0.5, 2}, {0.5, 3}, {2, 0.5}, {3, 0.5}, {0.1, 0.1}, {50, 0.7}, {1, 1}, {1e3, 1e3}}) {
    const auto distribution = makeDistribution(betaOf(alpha, beta));
    EXPECT_NEAR(distribution->mean(), alpha / (alpha + beta), 1e-15);
    EXPECT_NEAR(distribution->standardDeviation(),
                std::sqrt(alpha * beta / (alpha + beta + 1.0)) / (alpha + beta), 1e-14);
    // mirrored
    EXPECT_NEAR(distribution->quantile(0.3), 1.0 - makeDistribution(betaOf(beta, alpha))->quantile(0.7),
                1e-13);
  }
}

// No two variables have a larger product of deviations than those that rise together, or fall: by the
// quantiles at the middles of equal shares.
double mostCorrelation(const Distribution& a, const Distribution& b, bool together) {
  constexpr int kShares = 20000;
  double sum = 0.0;
  for (int i = 0; i < kShares; ++i) {
    const double p = (i + 0.5) / kShares;
    sum += (a.quantile(p) - a.mean()) * (b.quantile(together ? p : 1.0 - p) - b.mean());
  }
  return sum / kShares / (a.standardDeviation() * b.standardDeviation());
}

TEST(DistributionFamily, SamplesHaveTheCorrelationAskedForOrItIsRefused) {
  constexpr std::uint64_t kSamples = 1u << 15;
  int refused = 0, drawn = 0;
  for (std::uint64_t row = 0; row < 24; ++row) {
    Random random(2000 + row);
    Scene scene;
    for (int i = 0; i < 2; ++i) {
      // half of them of the kind whose quantile takes a search
      DesignVariable variable = anyVariable(random, random.chance(0.5) ? 0 : random.below(kKinds));
      auto& parameters = variable.distribution_parameters;
      // sampled moments of what is rarer than a sample in a thousand say nothing
      if (variable.distribution == "beta")
        parameters = {{"alpha", random.ofSize(0.1, 1e3)}, {"beta", random.ofSize(0.3, 1e3)}};
      if (variable.distribution == "weibull") parameters["shape"] = random.ofSize(0.8, 50.0);
      variable.name = i == 0 ? "a" : "b";
      scene.design_variables.push_back(variable);
    }
    const double asked = random.between(-0.95, 0.95);
    scene.correlations = {{0, 1, asked}};
    const std::string names = nameOf(scene.design_variables[0]) + " and " +
                              nameOf(scene.design_variables[1]) + ", correlation " + std::to_string(asked);
    const auto a = makeDistribution(scene.design_variables[0]),
               b = makeDistribution(scene.design_variables[1]);
    try {
      const Sampler sampler(scene, {0, 1}, SamplerType::sobol, kSamples, 5);
      ++drawn;
      Eigen::MatrixXd samples(2, static_cast<Eigen::Index>(kSamples));
      for (std::uint64_t i = 0; i < kSamples; ++i)
        sampler.sample(i, samples.col(static_cast<Eigen::Index>(i)).data());
      samples.row(0).array() -= a->mean();
      samples.row(1).array() -= b->mean();
      const double found = samples.row(0).dot(samples.row(1)) /
                           (static_cast<double>(kSamples) * a->standardDeviation() * b->standardDeviation());
      EXPECT_NEAR(found, asked, 5e-3) << names;
    } catch (const std::invalid_argument& error) {
      ++refused;
      EXPECT_NE(std::string(error.what()).find("their distributions allow"), std::string::npos)
          << error.what();
      EXPECT_GT(std::abs(asked), 0.97 * std::abs(mostCorrelation(*a, *b, asked > 0.0))) << names;
    }
  }
  EXPECT_GT(drawn, 8);
  EXPECT_GT(refused, 2);
}

}  // namespace
}  // namespace cable_variation
