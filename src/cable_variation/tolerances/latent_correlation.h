#pragma once  // internal to tolerances/

#include <vector>

#include <Eigen/Core>

#include <cable_variation/tolerances/marginal.h>

namespace cable_variation {

/// Normal variables whose scores, put through the marginals, have the correlation coefficients of the scene:
/// their own correlation matrix (normal to anything, NORTA; Cario and Nelson 1997). By Mehler's formula the
/// coefficient of two variables is a power series in that of their scores, with the variables' Hermite
/// coefficients; it is met to 1e-5, discrete variables with scores correlated beyond 0.97 to 1e-3.
/// @param variables indices into Scene::design_variables @param marginals of each
/// Throws std::invalid_argument that names the variables: correlationMatrix(), a coefficient that variables
/// of these distributions cannot have, with the range that they can, or one that they cannot have together.
Eigen::MatrixXd latentCorrelation(const Scene& scene, const std::vector<std::size_t>& variables,
                                  const std::vector<const Marginal*>& marginals);

}  // namespace cable_variation
