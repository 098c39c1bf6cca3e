#include <cable_variation/tolerances/sampler.h>

#include <array>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

#include <Eigen/Cholesky>
#include <boost/math/special_functions/gamma.hpp>

#include <cable_variation/math/normal.h>
#include <cable_variation/tolerances/latent_correlation.h>

namespace cable_variation {

namespace {

constexpr std::size_t kNowhere = std::numeric_limits<std::size_t>::max();

std::vector<bool> marked(const Scene& scene, const std::vector<std::size_t>& variables) {
  std::vector<bool> asked(scene.design_variables.size(), false);
  for (const std::size_t variable : variables) {
    if (variable >= asked.size()) {
      throw std::invalid_argument("design variable " + std::to_string(variable) + " of a scene with " +
                                  std::to_string(asked.size()));
    }
    if (asked[variable]) {
      throw std::invalid_argument("design variable '" + scene.design_variables[variable].name +
                                  "' is asked for twice");
    }
    asked[variable] = true;
  }
  return asked;
}

// The distance from the centre of a region below which a share u lies, over its radius.
double radiusOf(int dimensions, double sigma, double share, double u) {
  if (sigma == 0.0) return dimensions == 3 ? std::cbrt(u) : std::sqrt(u);
  const double squared =
      dimensions == 3 ? 2.0 * boost::math::gamma_p_inv(1.5, u * share) : -2.0 * std::log1p(-u * share);
  return std::min(std::sqrt(squared) / sigma, 1.0);
}

}  // namespace

Sampler::Sampler(const Scene& scene, const std::vector<std::size_t>& variables, SamplerType type,
                 std::uint64_t count, std::uint64_t seed)
    : points_(type, plan(scene, variables), count, seed) {
  std::vector<std::size_t> asked;
  std::vector<const Marginal*> marginals;
  for (const std::size_t i : correlated_) {
    asked.push_back(variables[i]);
    marginals.push_back(&marginals_[i]);
  }
  if (!asked.empty()) factor_ = latentCorrelation(scene, asked, marginals).llt().matrixL();
}

std::size_t Sampler::plan(const Scene& scene, const std::vector<std::size_t>& variables) {
  const std::vector<bool> asked = marked(scene, variables);
  std::vector<std::size_t> place(asked.size(), kNowhere);
  for (std::size_t i = 0; i < variables.size(); ++i) {
    place[variables[i]] = i;
    marginals_.emplace_back(scene.design_variables[variables[i]]);
  }
  sources_.resize(variables.size());
  for (const Correlation& correlation : scene.correlations) {
    if (!asked[correlation.first] || !asked[correlation.second]) continue;
    sources_[place[correlation.first]].correlated = sources_[place[correlation.second]].correlated = true;
  }
  for (const ToleranceRegion& tolerance : scene.tolerance_regions) {
    Region region;
    region.dimensions = static_cast<int>(tolerance.variables.size());
    region.radius = tolerance.radius;
    region.into.fill(kNowhere);
    bool any = false;
    for (std::size_t k = 0; k < tolerance.variables.size(); ++k) {
      region.into[k] = place[tolerance.variables[k]];
      if (region.into[k] == kNowhere) continue;
      sources_[region.into[k]].of_region = any = true;
    }
    if (!any) continue;
    if (!tolerance.uniform) {
      region.sigma = tolerance.sigma;
      region.share = boost::math::gamma_p(0.5 * region.dimensions, 0.5 * region.sigma * region.sigma);
    }
    regions_.push_back(region);
  }

  std::size_t coordinates = 0;
  for (std::size_t i = 0; i < sources_.size(); ++i) {
    if (sources_[i].of_region) continue;
    if (sources_[i].correlated) correlated_.push_back(i);
    sources_[i].coordinate = coordinates++;
  }
  for (Region& region : regions_) {
    region.coordinate = coordinates;
    coordinates += static_cast<std::size_t>(region.dimensions);
  }
  return coordinates;
}

void Sampler::sample(std::uint64_t index, double* deviations) const {
  constexpr std::size_t kUsual = 32;  // coordinates that need no allocation
  std::array<double, kUsual> few;
  std::vector<double> many;
  double* point = few.data();
  if (points_.dimensions() > kUsual) {
    many.resize(points_.dimensions());
    point = many.data();
  }
  points_.point(index, point);
  for (std::size_t i = 0; i < sources_.size(); ++i) {
    const Source& source = sources_[i];
    if (source.of_region || source.correlated) continue;
    deviations[i] = marginals_[i].ofUniform(point[source.coordinate]);
  }
  for (const std::size_t i : correlated_) {
    double& own = point[sources_[i].coordinate];
    own = normalScore(own);
  }
  for (std::size_t row = 0; row < correlated_.size(); ++row) {
    double score = 0.0;
    for (std::size_t column = 0; column <= row; ++column) {
      score += factor_(static_cast<Eigen::Index>(row), static_cast<Eigen::Index>(column)) *
               point[sources_[correlated_[column]].coordinate];
    }
    deviations[correlated_[row]] = marginals_[correlated_[row]].ofScore(score);
  }
  for (const Region& region : regions_) place(region, point + region.coordinate, deviations);
}

void Sampler::place(const Region& region, const double* point, double* deviations) const {
  const double radius = region.radius * radiusOf(region.dimensions, region.sigma, region.share, point[0]);
  const double around = 2.0 * M_PI * point[1];
  std::array<double, 3> at = {radius * std::cos(around), radius * std::sin(around), 0.0};
  if (region.dimensions == 3) {
    const double height = 2.0 * point[2] - 1.0, beside = std::sqrt((1.0 - height) * (1.0 + height));
    at = {at[0] * beside, at[1] * beside, radius * height};
  }
  for (std::size_t k = 0; k < at.size(); ++k) {
    if (region.into[k] != kNowhere) deviations[region.into[k]] = at[k];
  }
}

}  // namespace cable_variation
