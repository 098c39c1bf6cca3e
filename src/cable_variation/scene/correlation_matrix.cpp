#include <cable_variation/scene/correlation_matrix.h>

#include <cmath>
#include <stdexcept>
#include <string>

#include <Eigen/Eigenvalues>

#include <cable_variation/util/name_list.h>
#include <cable_variation/util/quantity.h>

namespace cable_variation {

Eigen::MatrixXd correlationMatrix(const Scene& scene, const std::vector<std::size_t>& variables) {
  constexpr double kSmallest = 1e-9;  // eigenvalue; below it one variable follows from the others
  constexpr double kTakesPart = 1e-6;
  const auto size = static_cast<Eigen::Index>(variables.size());
  Eigen::MatrixXd matrix = Eigen::MatrixXd::Identity(size, size);
  if (scene.correlations.empty()) return matrix;
  std::vector<Eigen::Index> place(scene.design_variables.size(), -1);
  for (Eigen::Index i = 0; i < size; ++i) place[variables[static_cast<std::size_t>(i)]] = i;
  for (const Correlation& correlation : scene.correlations) {
    const Eigen::Index i = place[correlation.first], j = place[correlation.second];
    if (i >= 0 && j >= 0) matrix(i, j) = matrix(j, i) = correlation.coefficient;
  }
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(matrix);
  if (size > 0 && !(solver.eigenvalues()[0] > kSmallest)) {
    std::vector<std::string> names;
    for (Eigen::Index i = 0; i < size; ++i) {
      if (std::abs(solver.eigenvectors()(i, 0)) > kTakesPart) {
        names.push_back("'" + scene.design_variables[variables[static_cast<std::size_t>(i)]].name + "'");
      }
    }
    throw std::invalid_argument("the correlations of " + joined(names) +
                                " are not positive definite, smallest eigenvalue " +
                                shortNumber(solver.eigenvalues()[0]) + "; expected more than 0");
  }
  return matrix;
}

}  // namespace cable_variation
