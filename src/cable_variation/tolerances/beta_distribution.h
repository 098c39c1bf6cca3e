#pragma once  // internal to tolerances/

#include <cable_variation/tolerances/distribution.h>

namespace cable_variation {

/// A beta distribution between two limits, of any parameters: bell, slope, or the two ends with little
/// between.
class BetaDistribution final : public Distribution {
 public:
  /// @param low, high the limits, low < high
  /// @param alpha, beta both > 0; density (x - low)^(alpha - 1) (high - x)^(beta - 1)
  BetaDistribution(double low, double high, double alpha, double beta);

  double mean() const override;
  double standardDeviation() const override;
  double cdf(double deviation) const override;
  /// By bracketing, in the logarithm of the distances to the limits and that of the smaller share: it ends
  /// for all parameters. Where the density is infinite at a limit, numbers next to it are as dense as a
  /// double allows, and more than one share belongs to each.
  double quantile(double probability) const override;

 private:
  double low_, high_;
  double alpha_, beta_;
};

}  // namespace cable_variation
