#include <cable_variation/tolerances/tolerances.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

#include <cable_variation/scene/correlation_matrix.h>
#include <cable_variation/tolerances/distribution.h>

namespace cable_variation {
namespace {

void requireIndices(const Scene& scene, const std::vector<std::size_t>& variables) {
  for (const std::size_t variable : variables) {
    if (variable < scene.design_variables.size()) continue;
    throw std::invalid_argument("design variable " + std::to_string(variable) + " of a scene with " +
                                std::to_string(scene.design_variables.size()));
  }
}

}  // namespace

Spread spreadOf(const Scene& scene, const std::vector<std::size_t>& variables) {
  requireIndices(scene, variables);
  const auto size = static_cast<Eigen::Index>(variables.size());
  Spread spread;
  spread.mean.resize(size);
  Eigen::VectorXd sigma(size);
  for (Eigen::Index i = 0; i < size; ++i) {
    const auto distribution =
        makeDistribution(scene.design_variables[variables[static_cast<std::size_t>(i)]]);
    spread.mean[i] = distribution->mean();
    sigma[i] = distribution->standardDeviation();
  }
  // The coordinates of a region are uncorrelated: it looks the same from both sides of each axis.
  spread.covariance = sigma.asDiagonal() * correlationMatrix(scene, variables) * sigma.asDiagonal();
  return spread;
}

WorstCase worstCase(const Scene& scene, const std::vector<std::size_t>& variables,
                    const Eigen::VectorXd& gradient) {
  requireIndices(scene, variables);
  if (static_cast<std::size_t>(gradient.size()) != variables.size()) {
    throw std::invalid_argument("a gradient of " + std::to_string(gradient.size()) + " numbers for " +
                                std::to_string(variables.size()) + " design variables");
  }
  std::vector<const ToleranceRegion*> region_of(scene.design_variables.size(), nullptr);
  for (const ToleranceRegion& region : scene.tolerance_regions) {
    for (const std::size_t variable : region.variables) region_of[variable] = &region;
  }
  WorstCase worst;
  for (std::size_t i = 0; i < variables.size(); ++i) {
    if (region_of[variables[i]]) continue;
    const DesignVariable& variable = scene.design_variables[variables[i]];
    const double slope = gradient[static_cast<Eigen::Index>(i)];
    worst.low += std::min(slope * variable.lower, slope * variable.upper);
    worst.high += std::max(slope * variable.lower, slope * variable.upper);
  }
  for (const ToleranceRegion& region : scene.tolerance_regions) {
    double squared = 0.0;
    for (std::size_t i = 0; i < variables.size(); ++i) {
      const double slope = gradient[static_cast<Eigen::Index>(i)];
      if (region_of[variables[i]] == &region) squared += slope * slope;
    }
    worst.low -= region.radius * std::sqrt(squared);
    worst.high += region.radius * std::sqrt(squared);
  }
  return worst;
}

}  // namespace cable_variation
