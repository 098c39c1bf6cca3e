// Distributions against closed forms, and mean and standard deviation against integrals of the quantile.
#include <cable_variation/tolerances/distribution.h>

#include <cmath>
#include <map>
#include <stdexcept>
#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace cable_variation {
namespace {

using Parameters = std::map<std::string, double>;

DesignVariable variableOf(const std::string& distribution, const Parameters& parameters = {},
                          double lower = -2.0, double upper = 4.0) {
  DesignVariable variable;
  variable.name = "x";
  variable.lower = lower;
  variable.upper = upper;
  variable.distribution = distribution;
  variable.distribution_parameters = parameters;
  return variable;
}

DesignVariable valuesOf(const std::string& distribution, const std::vector<double>& values,
                        const std::vector<double>& weights = {}) {
  DesignVariable variable = variableOf(distribution);
  variable.distribution_values = values;
  variable.distribution_weights = weights;
  return variable;
}

DesignVariable regionOf(const std::string& shape, double radius, const Parameters& parameters = {}) {
  return variableOf(shape, parameters, -radius, radius);
}

std::vector<DesignVariable> continuous() {
  return {variableOf("normal", {{"sigma", 3.0}}),
          variableOf("truncated_normal", {{"sigma", 3.0}}),
          variableOf("truncated_normal", {{"sigma", 0.01}}),
          variableOf("uniform"),
          variableOf("triangular", {{"mode", 1.0}}),
          variableOf("triangular", {{"mode", -2.0}}),
          variableOf("trapezoidal", {{"plateau", 0.4}}),
          variableOf("trapezoidal", {{"plateau", 0.0}}),
          variableOf("trapezoidal", {{"plateau", 1.0}}),
          variableOf("beta", {{"alpha", 2.0}, {"beta", 5.0}}),
          variableOf("weibull", {{"shape", 2.0}, {"scale", 1.5}}),
          variableOf("weibull", {{"shape", 1.2}}),
          variableOf("skew_normal", {{"shape", -3.0}, {"sigma", 3.0}}),
          variableOf("skew_normal", {{"shape", 200.0}, {"sigma", 3.0}}),
          valuesOf("empirical", {0.25, -0.4, 0.1, 0.1, 1.3}),
          regionOf("ball", 2.0),
          regionOf("disc", 2.0),
          regionOf("ball", 2.0, {{"sigma", 2.0}}),
          regionOf("disc", 2.0, {{"sigma", 2.0}}),
          regionOf("cone", 2.0, {{"sigma", 0.5}})};
}

std::string nameOf(const DesignVariable& variable) {
  std::string name = variable.distribution;
  for (const auto& [key, value] : variable.distribution_parameters)
    name += " " + key + " " + std::to_string(value);
  return name;
}

// E[f(X)] = ∫ f(Q(p)) dp over p = (1 - cos πt)/2 with t = (1 - cos πu)/2, which takes all four ends of the
// midpoint rule to the fourth power: errors below 1e-6 at 500 points, tails included.
template <class F>
double expectation(const Distribution& distribution, const F& f) {
  constexpr int kPoints = 500;
  double sum = 0.0;
  for (int i = 0; i < kPoints; ++i) {
    const double u = (i + 0.5) / kPoints;
    const double t = 0.5 * (1.0 - std::cos(M_PI * u));
    const double p = 0.5 * (1.0 - std::cos(M_PI * t));
    const double weight = 0.25 * M_PI * M_PI * std::sin(M_PI * u) * std::sin(M_PI * t);
    sum += weight * f(distribution.quantile(p)) / kPoints;
  }
  return sum;
}

TEST(Distribution, MeanAndStandardDeviationAreThoseOfTheQuantile) {
  for (const DesignVariable& variable : continuous()) {
    const auto distribution = makeDistribution(variable);
    const double mean = expectation(*distribution, [](double x) { return x; });
    const double variance = expectation(*distribution, [&](double x) { return (x - mean) * (x - mean); });
    // empirical: kinks at the samples
    const double tolerance = variable.distribution == "empirical" ? 1e-5 : 2e-6;
    EXPECT_NEAR(distribution->mean(), mean, tolerance) << nameOf(variable);
    EXPECT_NEAR(distribution->standardDeviation(), std::sqrt(variance), tolerance) << nameOf(variable);
  }
}

TEST(Distribution, QuantileIsTheInverseOfTheCdf) {
  for (const DesignVariable& variable : continuous()) {
    const auto distribution = makeDistribution(variable);
    double last = -1e9;
    for (const double p : {1e-6, 0.001, 0.05, 0.3, 0.5, 0.77, 0.95, 0.999, 1.0 - 1e-6}) {
      const double x = distribution->quantile(p);
      EXPECT_GE(x, last) << nameOf(variable);
      last = x;
      const bool jumps = variable.distribution == "empirical" && (p < 0.1 || p > 0.9 || p == 0.5 || p == 0.3);
      if (jumps) continue;
      EXPECT_NEAR(distribution->cdf(x), p, 1e-10) << nameOf(variable) << " at " << p;
    }
  }
}

TEST(Distribution, LiesWhereItIsBounded) {
  for (const DesignVariable& variable : continuous()) {
    const std::string& type = variable.distribution;
    const auto distribution = makeDistribution(variable);
    if (type == "normal" || type == "skew_normal") continue;
    const bool measured = type == "empirical";
    EXPECT_EQ(distribution->cdf((measured ? -0.4 : variable.lower) - 1e-9), 0.0) << nameOf(variable);
    if (type == "weibull") continue;
    EXPECT_EQ(distribution->cdf(variable.upper + 1e-9), 1.0) << nameOf(variable);
  }
}

TEST(Distribution, ClosedForms) {
  // half width 3 about 1
  const auto normal = makeDistribution(variableOf("normal", {{"sigma", 3.0}}));
  EXPECT_DOUBLE_EQ(normal->mean(), 1.0);
  EXPECT_DOUBLE_EQ(normal->standardDeviation(), 1.0);
  EXPECT_NEAR(normal->cdf(2.0), 0.841344746068543, 1e-14);  // Φ(1)
  EXPECT_NEAR(normal->quantile(0.975), 1.0 + 1.959963984540054, 1e-13);

  // variance 1 - 2kφ(k)/(2Φ(k) - 1)
  const double k = 2.0, phi = std::exp(-0.5 * k * k) / std::sqrt(2.0 * M_PI);
  const auto truncated = makeDistribution(variableOf("truncated_normal", {{"sigma", k}}));
  EXPECT_NEAR(truncated->standardDeviation(),
              1.5 * std::sqrt(1.0 - 2.0 * k * phi / std::erf(k / std::sqrt(2.0))), 1e-13);

  const auto uniform = makeDistribution(variableOf("uniform"));
  EXPECT_NEAR(uniform->standardDeviation(), 6.0 / std::sqrt(12.0), 1e-14);
  EXPECT_NEAR(uniform->quantile(0.25), -0.5, 1e-14);

  // (a² + b² + c² - ab - ac - bc)/18 with a = -2, b = 4, c = 1
  const auto triangular = makeDistribution(variableOf("triangular", {{"mode", 1.0}}));
  EXPECT_NEAR(triangular->standardDeviation(), std::sqrt((4.0 + 16.0 + 1.0 + 8.0 + 2.0 - 4.0) / 18.0), 1e-14);

  // two uniform widths 4.2 and 1.8
  const auto trapezoidal = makeDistribution(variableOf("trapezoidal", {{"plateau", 0.4}}));
  EXPECT_NEAR(trapezoidal->standardDeviation(), std::sqrt((4.2 * 4.2 + 1.8 * 1.8) / 12.0), 1e-14);
  EXPECT_NEAR(trapezoidal->cdf(1.0), 0.5, 1e-15);

  const auto beta = makeDistribution(variableOf("beta", {{"alpha", 2.0}, {"beta", 5.0}}));
  EXPECT_NEAR(beta->mean(), -2.0 + 6.0 * 2.0 / 7.0, 1e-14);
  EXPECT_NEAR(beta->standardDeviation(), 6.0 * std::sqrt(10.0 / (49.0 * 8.0)), 1e-14);

  // Rayleigh: mean Γ(3/2), variance 1 - π/4, in scales
  const auto weibull = makeDistribution(variableOf("weibull", {{"shape", 2.0}, {"scale", 1.5}}));
  EXPECT_NEAR(weibull->mean(), -2.0 + 1.5 * std::sqrt(M_PI) / 2.0, 1e-13);
  EXPECT_NEAR(weibull->standardDeviation(), 1.5 * std::sqrt(1.0 - M_PI / 4.0), 1e-13);
  // without a scale as much lies outside the tolerance as of a normal one at 3 sigma
  const auto fitted = makeDistribution(variableOf("weibull", {{"shape", 1.2}}));
  EXPECT_NEAR(1.0 - fitted->cdf(4.0), std::erfc(3.0 / std::sqrt(2.0)), 1e-12);

  const auto skew = makeDistribution(variableOf("skew_normal", {{"shape", 5.0}, {"sigma", 3.0}}));
  EXPECT_DOUBLE_EQ(skew->mean(), 1.0);
  EXPECT_DOUBLE_EQ(skew->standardDeviation(), 1.0);
  EXPECT_LT(skew->quantile(0.5), 1.0) << "the median is on the short side";
}

TEST(Distribution, CoordinatesOfRegions) {
  EXPECT_NEAR(makeDistribution(regionOf("ball", 2.0))->standardDeviation(), 2.0 / std::sqrt(5.0), 1e-15);
  EXPECT_NEAR(makeDistribution(regionOf("disc", 2.0))->standardDeviation(), 1.0, 1e-15);
  EXPECT_NEAR(makeDistribution(regionOf("cone", 0.1))->standardDeviation(), 0.05, 1e-15);
  // a ball's slab: volume π h² (r - h/3) of 4/3 π r³
  EXPECT_NEAR(makeDistribution(regionOf("ball", 2.0))->cdf(-1.0), (2.0 - 1.0 / 3.0) / (32.0 / 3.0), 1e-13);
  // cut off far out it is a normal one
  const auto wide = makeDistribution(regionOf("disc", 2.0, {{"sigma", 8.0}}));
  EXPECT_NEAR(wide->standardDeviation(), 0.25, 1e-12);
  EXPECT_NEAR(wide->cdf(0.25), 0.841344746068543, 1e-12);
  // close in it is even
  const auto narrow = makeDistribution(regionOf("ball", 2.0, {{"sigma", 1e-3}}));
  EXPECT_NEAR(narrow->standardDeviation(), 2.0 / std::sqrt(5.0), 1e-6);
  // of a disc, ½ E[ρ²] with ρ's density ρ exp(-ρ²/2) up to k: ½ (2 - k² e/(1 - e)), e = exp(-k²/2)
  const double k = 2.0, e = std::exp(-0.5 * k * k);
  EXPECT_NEAR(makeDistribution(regionOf("disc", 2.0, {{"sigma", k}}))->standardDeviation(),
              std::sqrt(0.5 * (2.0 - k * k * e / (1.0 - e))), 1e-13);
}

TEST(Distribution, Discrete) {
  const auto distribution = makeDistribution(valuesOf("discrete", {4.0, 0.0, 1.0}, {0.25, 0.5, 0.25}));
  EXPECT_DOUBLE_EQ(distribution->mean(), 1.25);
  EXPECT_DOUBLE_EQ(distribution->standardDeviation(), std::sqrt(0.25 * 16.0 + 0.25 - 1.25 * 1.25));
  EXPECT_EQ(distribution->cdf(-0.1), 0.0);
  EXPECT_EQ(distribution->cdf(0.0), 0.5);
  EXPECT_EQ(distribution->cdf(3.9), 0.75);
  EXPECT_EQ(distribution->cdf(4.0), 1.0);
  EXPECT_EQ(distribution->quantile(0.5), 0.0);
  EXPECT_EQ(distribution->quantile(0.51), 1.0);
  EXPECT_EQ(distribution->quantile(0.99), 4.0);
}

TEST(Distribution, EmpiricalByHazensRule) {
  const auto distribution = makeDistribution(valuesOf("empirical", {3.0, 1.0, 2.0, 6.0}));
  EXPECT_DOUBLE_EQ(distribution->mean(), 3.0);
  EXPECT_DOUBLE_EQ(distribution->quantile(0.125), 1.0);  // (1 - 0.5)/4
  EXPECT_DOUBLE_EQ(distribution->quantile(0.375), 2.0);
  EXPECT_DOUBLE_EQ(distribution->quantile(0.5), 2.5);  // the median
  EXPECT_DOUBLE_EQ(distribution->quantile(0.99), 6.0);
  EXPECT_DOUBLE_EQ(distribution->cdf(2.5), 0.5);
  EXPECT_DOUBLE_EQ(distribution->cdf(1.0), 0.125);
}

std::string refusal(const DesignVariable& variable) {
  try {
    makeDistribution(variable);
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "taken";
}

TEST(Distribution, RefusesWhatIsNone) {
  const std::string who = "design variable 'x', distribution ";
  EXPECT_EQ(refusal(variableOf("gaussian")), who + "gaussian: there is no such distribution");
  EXPECT_EQ(refusal(variableOf("normal", {{"sigma", 0.0}})), who + "normal: sigma 0; expected more than 0");
  EXPECT_EQ(refusal(variableOf("normal", {{"sigma", std::nan("")}})),
            who + "normal: sigma nan; expected more than 0");
  EXPECT_EQ(refusal(variableOf("uniform", {}, 0.0, 0.0)),
            who + "uniform: tolerance from 0 to 0; expected lower < upper");
  EXPECT_EQ(refusal(variableOf("beta", {{"alpha", 1.0}})), who + "beta: 'beta' is missing");
  EXPECT_EQ(refusal(variableOf("triangular", {{"mode", 5.0}})),
            who + "triangular: mode 5; expected between -2 and 4");
  EXPECT_EQ(refusal(variableOf("weibull", {{"shape", 0.01}})),
            who + "weibull: shape 0.01; expected between 0.5 and 50");
  EXPECT_EQ(refusal(valuesOf("discrete", {1.0, 2.0}, {1.0})),
            who + "discrete: 1 probabilities of 2 values; expected one for each");
  EXPECT_EQ(refusal(valuesOf("discrete", {1.0, 2.0}, {1.0, 0.0})),
            who + "discrete: all values are the same; expected others too");
  EXPECT_EQ(refusal(valuesOf("empirical", {1.0})), who + "empirical: 1 samples; expected 2 or more");
  EXPECT_EQ(refusal(valuesOf("empirical", {1.0, std::nan("")})), who + "empirical: a value is not finite");
}

}  // namespace
}  // namespace cable_variation
