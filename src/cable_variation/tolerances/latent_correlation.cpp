#include <cable_variation/tolerances/latent_correlation.h>

#include <cmath>
#include <stdexcept>
#include <string>

#include <Eigen/Eigenvalues>

#include <cable_variation/scene/correlation_matrix.h>
#include <cable_variation/statistics/quantile_search.h>
#include <cable_variation/util/quantity.h>

namespace cable_variation {

namespace {

using Eigen::VectorXd;

constexpr double kMostLatent = 0.9999;

// Coefficients of a variable in normalised Hermite polynomials h_k, k >= 1, of the score z. By parts,
// a_k = ∫ x h_k φ dz = 1/√k ∫ h_(k-1) φ dx: the deviation x need not be continuous.
class HermiteSeries {
 public:
  explicit HermiteSeries(const Marginal& marginal)
      : marginal_(marginal),
        sigma_(marginal.distribution().standardDeviation()),
        coefficients_(VectorXd::Zero(kTerms)) {
    constexpr double kReach = 8.0;
    constexpr int kSteps = 8192;
    double from = -kReach, at_from = marginal.ofScore(from);
    for (int i = 1; i <= kSteps; ++i) {
      const double to = -kReach + 2.0 * kReach * i / kSteps, at_to = marginal.ofScore(to);
      add(from, at_from, to, at_to);
      from = to;
      at_from = at_to;
    }
    coefficients_ /= sigma_;
  }

  const VectorXd& coefficients() const { return coefficients_; }

 private:
  static constexpr Eigen::Index kTerms = 400;

  void add(double from, double at_from, double to, double at_to) {
    constexpr double kJump = 0.02, kNarrow = 1e-9;
    const double middle = 0.5 * (from + to), rise = at_to - at_from;
    if (rise == 0.0) return;
    // h_k √φ is bounded: far out only large rises count
    if (rise * std::exp(-0.25 * middle * middle) > kJump * sigma_ && to - from > kNarrow) {
      const double at_middle = marginal_.ofScore(middle);
      add(from, at_from, middle, at_middle);
      add(middle, at_middle, to, at_to);
      return;
    }
    double before = 0.0, here = std::exp(-0.5 * middle * middle) / std::sqrt(2.0 * M_PI);
    for (Eigen::Index k = 1; k <= kTerms; ++k) {
      const double order = static_cast<double>(k);
      coefficients_[k - 1] += rise * here / std::sqrt(order);
      const double next = (middle * here - std::sqrt(order - 1.0) * before) / std::sqrt(order);
      before = here;
      here = next;
    }
  }

  const Marginal& marginal_;
  double sigma_;
  VectorXd coefficients_;
};

double correlationAt(const VectorXd& products, double latent) {
  double sum = 0.0;
  for (Eigen::Index k = products.size(); k-- > 0;) sum = latent * (sum + products[k]);
  return sum;
}

}  // namespace

Eigen::MatrixXd latentCorrelation(const Scene& scene, const std::vector<std::size_t>& variables,
                                  const std::vector<const Marginal*>& marginals) {
  Eigen::MatrixXd matrix = correlationMatrix(scene, variables);
  const auto name = [&](Eigen::Index i) {
    return "'" + scene.design_variables[variables[static_cast<std::size_t>(i)]].name + "'";
  };
  const Eigen::Index size = matrix.rows();
  std::vector<VectorXd> series(static_cast<std::size_t>(size));
  const auto seriesOf = [&](Eigen::Index i) -> const VectorXd& {
    VectorXd& known = series[static_cast<std::size_t>(i)];
    if (known.size() == 0) known = HermiteSeries(*marginals[static_cast<std::size_t>(i)]).coefficients();
    return known;
  };
  for (Eigen::Index i = 0; i < size; ++i) {
    for (Eigen::Index j = 0; j < i; ++j) {
      if (matrix(i, j) == 0.0) continue;
      const VectorXd products = seriesOf(i).cwiseProduct(seriesOf(j));
      const auto correlation = [&](double latent) { return correlationAt(products, latent); };
      const double least = correlation(-kMostLatent), most = correlation(kMostLatent);
      if (matrix(i, j) < least || matrix(i, j) > most) {
        throw std::invalid_argument("correlation " + shortNumber(matrix(i, j)) + " of " + name(j) + " and " +
                                    name(i) + "; their distributions allow " + shortNumber(least) + " to " +
                                    shortNumber(most));
      }
      matrix(i, j) = matrix(j, i) = quantileOf(correlation, matrix(i, j), -kMostLatent, kMostLatent);
    }
  }
  constexpr double kSmallest = 1e-9;  // eigenvalue; below it one score follows from the others
  if (size > 0) {
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(matrix, Eigen::EigenvaluesOnly);
    if (!(solver.eigenvalues()[0] > kSmallest)) {
      std::string names = name(0);
      for (Eigen::Index i = 1; i < size; ++i) names += ", " + name(i);
      throw std::invalid_argument("the correlations of " + names +
                                  " cannot be had together with their distributions, smallest eigenvalue " +
                                  shortNumber(solver.eigenvalues()[0]) + " of their normal scores");
    }
  }
  return matrix;
}

}  // namespace cable_variation
