#pragma once

#include <vector>

#include <Eigen/Core>

#include <cable_variation/scene/scene.h>

namespace cable_variation {

/// Mean [unit] and covariance of the deviations of some design variables, from
/// distributions, regions and correlations. Correlation coefficients are those of the
/// variables themselves. Throws std::invalid_argument: makeDistribution(), or correlations
/// that are not positive definite, with the smallest eigenvalue and the names.
struct Spread {
  Eigen::VectorXd mean;
  Eigen::MatrixXd covariance;
};
Spread spreadOf(const Scene& scene, const std::vector<std::size_t>& variables);

/// The smallest and the largest change that a linear measure can take within
/// the tolerances: boxes, and regions as the balls they are.
struct WorstCase {
  double low = 0.0, high = 0.0;
};
/// @param gradient of the measure by each of `variables`
WorstCase worstCase(const Scene& scene, const std::vector<std::size_t>& variables,
                    const Eigen::VectorXd& gradient);

}  // namespace cable_variation
