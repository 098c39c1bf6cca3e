#pragma once  // internal to tolerances/

#include <vector>

#include <cable_variation/tolerances/distribution.h>

namespace cable_variation {

/// A few values, each with its probability.
class DiscreteDistribution final : public Distribution {
 public:
  /// @param weights of the values, which add up to 1
  DiscreteDistribution(const std::vector<double>& values, const std::vector<double>& weights);

  double mean() const override;
  double standardDeviation() const override;
  double cdf(double deviation) const override;
  /// The smallest value up to which at least `probability` lies.
  double quantile(double probability) const override;

 private:
  struct Value {
    double deviation, weight, cumulative;
  };
  std::vector<Value> values_;  // increasing
};

/// Measured samples. Between them the quantile is linear, the i-th of n smallest being that of (i - 0.5)/n
/// (Hazen's rule, type 5 of Hyndman and Fan, Sample Quantiles in Statistical Packages, 1996), and constant
/// beyond: nothing is made up outside of what was measured, and the mean is that of the samples.
/// The standard deviation is that of this distribution.
class EmpiricalDistribution final : public Distribution {
 public:
  explicit EmpiricalDistribution(std::vector<double> samples);

  double mean() const override;
  double standardDeviation() const override;
  double cdf(double deviation) const override;
  double quantile(double probability) const override;

 private:
  std::vector<double> samples_;  // increasing
};

}  // namespace cable_variation
