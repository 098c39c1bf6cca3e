#pragma once

#include <vector>

#include <Eigen/Core>

#include <cable_variation/scene/scene.h>

namespace cable_variation {

/// Correlation coefficients between some of the scene's design variables (indices); 1 on the diagonal.
/// Throws std::invalid_argument that names the variables and the smallest eigenvalue unless it is positive
/// definite: no production could vary like that.
Eigen::MatrixXd correlationMatrix(const Scene& scene, const std::vector<std::size_t>& variables);

}  // namespace cable_variation
