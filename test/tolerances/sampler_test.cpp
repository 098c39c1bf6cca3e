// Samples of design variables against their distributions, regions and correlations.
#include <cable_variation/tolerances/sampler.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include <gtest/gtest.h>

#include <cable_variation/math/normal.h>
#include <cable_variation/tolerances/latent_correlation.h>
#include <cable_variation/tolerances/tolerances.h>

namespace cable_variation {
namespace {

DesignVariable variableOf(const std::string& name, const std::string& distribution,
                          const std::map<std::string, double>& parameters = {}) {
  DesignVariable variable;
  variable.name = name;
  variable.lower = -2.0;
  variable.upper = 4.0;
  variable.distribution = distribution;
  variable.distribution_parameters = parameters;
  return variable;
}

std::vector<DesignVariable> variablesOfAllKinds() {
  std::vector<DesignVariable> variables = {variableOf("a", "normal"),
                                           variableOf("b", "truncated_normal", {{"sigma", 1.0}}),
                                           variableOf("c", "uniform"),
                                           variableOf("d", "triangular"),
                                           variableOf("e", "trapezoidal"),
                                           variableOf("f", "beta", {{"alpha", 0.5}, {"beta", 5.0}}),
                                           variableOf("g", "weibull", {{"shape", 1.5}}),
                                           variableOf("h", "skew_normal", {{"shape", -4.0}}),
                                           variableOf("i", "discrete"),
                                           variableOf("j", "empirical")};
  variables[8].distribution_values = {-1.0, 0.0, 2.0};
  variables[8].distribution_weights = {0.2, 0.5, 0.3};
  variables[9].distribution_values = {-1.0, -0.5, 0.3, 0.4, 2.0};
  return variables;
}

std::vector<std::size_t> allOf(const Scene& scene) {
  std::vector<std::size_t> all(scene.design_variables.size());
  for (std::size_t i = 0; i < all.size(); ++i) all[i] = i;
  return all;
}

Eigen::MatrixXd samplesOf(const Sampler& sampler, std::uint64_t count) {
  Eigen::MatrixXd samples(static_cast<Eigen::Index>(sampler.variableCount()),
                          static_cast<Eigen::Index>(count));
  for (std::uint64_t i = 0; i < count; ++i)
    sampler.sample(i, samples.col(static_cast<Eigen::Index>(i)).data());
  return samples;
}

Eigen::MatrixXd covarianceOf(const Eigen::MatrixXd& samples) {
  const Eigen::MatrixXd centred = samples.colwise() - samples.rowwise().mean();
  return centred * centred.transpose() / static_cast<double>(samples.cols());
}

TEST(Marginal, TableAndTrueQuantileAreTheSame) {
  for (const DesignVariable& variable : variablesOfAllKinds()) {
    const Marginal marginal(variable);
    const double sigma = marginal.distribution().standardDeviation();
    for (double score = -7.9; score < 8.0; score += 0.0137) {
      const double p = normalShare(score), direct = marginal.distribution().quantile(p);
      // Above, p is coarse; as checked: 1e-9, and between the places of the check not much more.
      const double slack = score > 5.0 ? 2.5e-16 / normalShare(-score) : 0.0;
      EXPECT_NEAR(marginal.ofScore(score), direct, (2e-9 + slack) * sigma) << variable.name << " " << score;
      EXPECT_NEAR(marginal.ofUniform(p), direct, (2e-9 + slack) * sigma) << variable.name << " " << score;
    }
  }
}

// Kolmogorov and Smirnov: the largest distance of n samples' distribution from the true one exceeds
// 1.95/√n with probability 0.001.
TEST(Sampler, SamplesFollowTheirDistributions) {
  constexpr std::uint64_t kCount = 20000;
  Scene scene;
  scene.design_variables = variablesOfAllKinds();
  for (const SamplerType type :
       {SamplerType::monte_carlo, SamplerType::latin_hypercube, SamplerType::sobol}) {
    const Eigen::MatrixXd samples = samplesOf(Sampler(scene, allOf(scene), type, kCount, 4), kCount);
    for (std::size_t v = 0; v < scene.design_variables.size(); ++v) {
      const auto distribution = makeDistribution(scene.design_variables[v]);
      std::vector<double> sorted;
      for (Eigen::Index i = 0; i < samples.cols(); ++i)
        sorted.push_back(samples(static_cast<Eigen::Index>(v), i));
      std::sort(sorted.begin(), sorted.end());
      double distance = 0.0;
      for (std::size_t i = 0; i < sorted.size(); ++i) {
        if (i + 1 < sorted.size() && sorted[i + 1] == sorted[i]) continue;  // a jump of both
        distance = std::max(distance, std::abs((i + 1.0) / kCount - distribution->cdf(sorted[i])));
      }
      EXPECT_LT(distance, 1.95 / std::sqrt(static_cast<double>(kCount)))
          << scene.design_variables[v].name << " " << toString(type);
    }
  }
}

Scene sceneWithRegion(const std::string& shape, bool uniform, double sigma) {
  Scene scene;
  scene.design_variables = {variableOf("before", "uniform")};
  ToleranceRegion region;
  region.radius = 2.0;
  region.uniform = uniform;
  region.sigma = sigma;
  const std::size_t dimensions = shape == "ball" ? 3 : 2;
  for (std::size_t i = 0; i < dimensions; ++i) {
    DesignVariable variable = variableOf(shape + std::to_string(i), shape);
    variable.lower = -region.radius;
    variable.upper = region.radius;
    if (!uniform) variable.distribution_parameters["sigma"] = sigma;
    region.variables.push_back(scene.design_variables.size());
    scene.design_variables.push_back(variable);
  }
  scene.tolerance_regions = {region};
  return scene;
}

// Each direction's coordinate follows the region's marginal, so the whole is right: the region looks the same
// from all sides, and a distribution is told by all its projections (Cramér and Wold 1936).
TEST(Sampler, RegionsAreJointlyRight) {
  constexpr std::uint64_t kCount = 20000;
  for (const std::string shape : {"ball", "disc", "cone"}) {
    for (const double sigma : {0.0, 1.0, 3.0}) {
      const Scene scene = sceneWithRegion(shape, sigma == 0.0, sigma);
      const Sampler sampler(scene, allOf(scene), SamplerType::monte_carlo, kCount, 9);
      const Eigen::MatrixXd samples = samplesOf(sampler, kCount);
      const Eigen::Index d = samples.rows() - 1;
      const Eigen::MatrixXd region = samples.bottomRows(d);
      EXPECT_LE(region.colwise().norm().maxCoeff(), 2.0 + 1e-12);
      const auto marginal = makeDistribution(scene.design_variables[1]);
      for (const Eigen::Vector3d& direction :
           {Eigen::Vector3d(1, 0, 0), Eigen::Vector3d(0.6, 0.8, 0), Eigen::Vector3d(-0.48, 0.64, 0.6)}) {
        if (d == 2 && direction.z() != 0.0) continue;
        std::vector<double> along;
        for (Eigen::Index i = 0; i < region.cols(); ++i)
          along.push_back(direction.head(d).dot(region.col(i)));
        std::sort(along.begin(), along.end());
        double distance = 0.0;
        for (std::size_t i = 0; i < along.size(); i += 20) {  // the cdf takes a quadrature
          distance = std::max(distance, std::abs((i + 0.5) / kCount - marginal->cdf(along[i])));
        }
        EXPECT_LT(distance, 1.95 / std::sqrt(static_cast<double>(kCount))) << shape << sigma;
      }
    }
  }
}

TEST(Sampler, OneVariableOfARegionHasItsMarginal) {
  const Scene scene = sceneWithRegion("ball", true, 0.0);
  constexpr std::uint64_t kCount = 20000;
  const Sampler sampler(scene, {2}, SamplerType::sobol, kCount, 9);
  const Eigen::MatrixXd samples = samplesOf(sampler, kCount);
  EXPECT_NEAR(std::sqrt(covarianceOf(samples)(0, 0)), 2.0 / std::sqrt(5.0), 0.002);  // r/√(d + 2)
}

Scene correlatedScene() {
  Scene scene;
  scene.design_variables = variablesOfAllKinds();
  // normal-uniform, uniform-skewed, discrete-empirical, weibull-normal
  scene.correlations = {{0, 2, 0.7}, {2, 7, -0.5}, {8, 9, 0.6}, {6, 0, 0.3}};
  return scene;
}

TEST(Sampler, MeansAndCovariancesAreThoseOfTheSpread) {
  constexpr std::uint64_t kCount = 1u << 17;
  const Scene scene = correlatedScene();
  const Spread spread = spreadOf(scene, allOf(scene));
  const Eigen::VectorXd sigma = spread.covariance.diagonal().cwiseSqrt();
  const Sampler sampler(scene, allOf(scene), SamplerType::sobol, kCount, 21);
  const Eigen::MatrixXd samples = samplesOf(sampler, kCount);
  const Eigen::VectorXd mean = samples.rowwise().mean();
  const Eigen::MatrixXd covariance = covarianceOf(samples);
  for (Eigen::Index i = 0; i < mean.size(); ++i) {
    EXPECT_NEAR(mean[i], spread.mean[i], 1e-3 * sigma[i]) << i;
    for (Eigen::Index j = 0; j <= i; ++j) {
      // a third of the standard error of as many independent samples: Sobol' points do better
      EXPECT_NEAR(covariance(i, j) / (sigma[i] * sigma[j]), spread.covariance(i, j) / (sigma[i] * sigma[j]),
                  1e-3)
          << i << " " << j;
    }
  }
}

// Two uniform variables of a Gaussian copula: ρ = 6/π asin(ρ_z/2) (Pearson 1907).
TEST(Sampler, ScoresOfUniformVariablesAreCorrelatedAsPearsonSays) {
  Scene scene;
  scene.design_variables = {variableOf("a", "uniform"), variableOf("b", "uniform")};
  const Marginal a(scene.design_variables[0]), b(scene.design_variables[1]);
  for (const double wanted : {-0.95, -0.3, 0.01, 0.5, 0.9}) {
    scene.correlations = {{0, 1, wanted}};
    const Eigen::MatrixXd latent = latentCorrelation(scene, {0, 1}, {&a, &b});
    EXPECT_NEAR(6.0 / M_PI * std::asin(0.5 * latent(1, 0)), wanted, 2e-6);
  }
}

// Two variables of values ±1, equally likely: ρ = 2/π asin ρ_z (Sheppard 1899). The series of jumps converges
// slowly.
TEST(Sampler, ScoresOfDiscreteVariablesAreCorrelatedAsSheppardSays) {
  Scene scene;
  scene.design_variables = {variableOf("a", "discrete"), variableOf("b", "discrete")};
  for (DesignVariable& variable : scene.design_variables) {
    variable.distribution_values = {-1.0, 1.0};
    variable.distribution_weights = {0.5, 0.5};
  }
  const Marginal a(scene.design_variables[0]), b(scene.design_variables[1]);
  for (const double wanted : {-0.8, 0.2, 0.8}) {
    scene.correlations = {{0, 1, wanted}};
    const Eigen::MatrixXd latent = latentCorrelation(scene, {0, 1}, {&a, &b});
    EXPECT_NEAR(2.0 / M_PI * std::asin(latent(1, 0)), wanted, 1e-5);
  }
}

TEST(Sampler, CorrelationsThatCannotBeAreRefused) {
  Scene scene;
  // values 0 and 1 with probabilities 0.99 and 0.01, and a normal variable: at most φ(2.326)/√(0.99 0.01) =
  // 0.268
  scene.design_variables = {variableOf("rare", "discrete"), variableOf("usual", "normal")};
  scene.design_variables[0].distribution_values = {0.0, 1.0};
  scene.design_variables[0].distribution_weights = {0.99, 0.01};
  scene.correlations = {{0, 1, 0.26}};
  EXPECT_NO_THROW(Sampler(scene, {0, 1}, SamplerType::monte_carlo, 1, 1));
  scene.correlations = {{0, 1, 0.3}};
  try {
    Sampler(scene, {0, 1}, SamplerType::monte_carlo, 1, 1);
    FAIL();
  } catch (const std::invalid_argument& error) {
    EXPECT_NE(std::string(error.what()).find("'rare' and 'usual'; their distributions allow -0.26"),
              std::string::npos)
        << error.what();
  }
  EXPECT_NO_THROW(Sampler(scene, {1}, SamplerType::monte_carlo, 1, 1));  // the other does not vary
}

TEST(Sampler, BadInputIsRefused) {
  const Scene scene = correlatedScene();
  EXPECT_THROW(Sampler(scene, {}, SamplerType::monte_carlo, 10, 1), std::invalid_argument);
  EXPECT_THROW(Sampler(scene, {0, 1, 0}, SamplerType::monte_carlo, 10, 1), std::invalid_argument);
  EXPECT_THROW(Sampler(scene, {10}, SamplerType::monte_carlo, 10, 1), std::invalid_argument);
  EXPECT_THROW(Sampler(scene, {0}, SamplerType::latin_hypercube, 0, 1), std::invalid_argument);
}

TEST(Sampler, ThreadsAndOrderDoNotMatter) {
  const Scene scene = correlatedScene();
  const Sampler sampler(scene, allOf(scene), SamplerType::latin_hypercube, 1000, 3);
  const Eigen::MatrixXd expected = samplesOf(sampler, 1000);
  Eigen::MatrixXd found = Eigen::MatrixXd::Zero(expected.rows(), expected.cols());
  std::vector<std::thread> threads;
  for (Eigen::Index t = 0; t < 4; ++t) {
    threads.emplace_back([&, t] {
      for (Eigen::Index i = found.cols() - 1 - t; i >= 0; i -= 4) {
        sampler.sample(static_cast<std::uint64_t>(i), found.col(i).data());
      }
    });
  }
  for (std::thread& thread : threads) thread.join();
  EXPECT_EQ(found, expected);
}

}  // namespace
}  // namespace cable_variation
