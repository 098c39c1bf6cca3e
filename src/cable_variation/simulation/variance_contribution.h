#pragma once

#include <cstdint>
#include <vector>

#include <Eigen/Core>

#include <cable_variation/tolerances/distribution.h>

namespace cable_variation {

/// Which variables the variance of each measure comes from, as samples tell: rows measures, columns
/// variables. Empty matrices: too few samples. Not a number: the measure does not vary.
struct VarianceContributions {
  std::uint64_t count = 0;     ///< samples used
  std::uint64_t left_out = 0;  ///< samples where some measure has no finite value

  /// Linear regression on all variables: slopes [measure's unit / variable's unit], and times the ratio of
  /// standard deviations.
  Eigen::MatrixXd slope, standardised;
  /// Standardised slope times correlation with the measure (Pratt 1987): the sampled counterpart of
  /// StabilityAnalysis::contribution. Of sum r_squared.
  Eigen::MatrixXd regression_share;
  Eigen::VectorXd r_squared;  ///< the share of the variance that a linear model explains

  /// First-order Sobol' indices Var(E[measure | variable]) / Var(measure): what would go if the variable had
  /// no tolerance, whatever the shape of its effect. Independent variables: the rest to a sum of 1 is by
  /// several together. Correlated ones share, and the sum may exceed 1. Of the means in equally likely bins
  /// of the variable, less their noise: of standard error about √(2 bins)/count, and, for a linear effect,
  /// low by 1 % of itself with 64 bins, by 8 % with 8.
  Eigen::MatrixXd first_order;
  std::size_t bins = 0;
};

/// Collects pairs of variables' deviations and measures' values: in constant memory, mergeable; the same
/// order of calls gives the same numbers bit for bit.
class VarianceContributor {
 public:
  static constexpr std::size_t kBins = 64;

  /// Equally likely bins of a variable lie between these.
  static std::vector<double> binEdges(const Distribution& distribution);

  /// @param edges of each variable, binEdges() @param measures their number
  VarianceContributor(std::vector<std::vector<double>> edges, std::size_t measures);

  /// @param deviations one per variable @param values one per measure; one that is not finite leaves the
  /// sample out
  void add(const double* deviations, const double* values);
  void leaveOut() { ++left_out_; }  ///< a sample without values
  void merge(const VarianceContributor& later);

  VarianceContributions contributions() const;

 private:
  struct Mean {
    std::uint64_t count = 0;
    double value = 0.0;
    void add(const Mean& other);
  };

  std::size_t variableCount() const { return edges_.size(); }
  void addRegression(VarianceContributions& result) const;
  void addFirstOrder(VarianceContributions& result) const;
  double firstOrder(std::size_t variable, std::size_t measure, std::size_t bins) const;

  std::vector<std::vector<double>> edges_;
  std::size_t measures_;
  std::uint64_t count_ = 0, left_out_ = 0;
  Eigen::VectorXd mean_;     // of variables, then measures
  Eigen::MatrixXd scatter_;  // sums of products about the means; lower triangle
  std::vector<Mean> bins_;   // per variable, bin and measure
  Eigen::VectorXd row_;      // of add()
};

}  // namespace cable_variation
