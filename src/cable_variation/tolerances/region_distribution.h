#pragma once  // internal to tolerances/

#include <cable_variation/tolerances/distribution.h>

namespace cable_variation {

/// One coordinate of a point in a ball of some dimensions (3: ball, 2: disc, cone).
class RegionDistribution final : public Distribution {
 public:
  /// Cut off at so few standard deviations a normal distribution is even, to 1e-12.
  static constexpr double kEven = 1e-6;

  /// @param radius of the ball
  /// @param sigma 0: the point is spread evenly; else normal, the radius being that many standard
  /// deviations of each coordinate, and cut off at the radius
  RegionDistribution(int dimensions, double radius, double sigma);

  double mean() const override { return 0.0; }
  /// Evenly: r / √(d + 2). Normal: r/k √(F(d + 2) / F(d)), F(n) the share of a chi-squared variable of n
  /// degrees of freedom below k².
  double standardDeviation() const override;
  double cdf(double deviation) const override;
  double quantile(double probability) const override;

 private:
  int dimensions_;
  double radius_;
  double sigma_;
};

}  // namespace cable_variation
