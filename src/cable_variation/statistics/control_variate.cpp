#include <cable_variation/statistics/control_variate.h>

#include <algorithm>
#include <cmath>

namespace cable_variation {

namespace {

constexpr double kRounding = 1e-15;  // of what remains of a measure that is linear

struct Half {
  explicit Half(const JointMoments& moments) : m(moments), n(static_cast<double>(moments.count())) {}

  double bestMeanFactor() const { return m.central(0, 2) > 0.0 ? m.central(1, 1) / m.central(0, 2) : 0.0; }
  double bestVarianceFactor() const {
    return varianceOfSquareY() > 0.0 ? covarianceOfSquares() / varianceOfSquareY() : 0.0;
  }
  double varianceOfSquareX() const { return m.central(4, 0) - m.central(2, 0) * m.central(2, 0); }
  double varianceOfSquareY() const { return m.central(0, 4) - m.central(0, 2) * m.central(0, 2); }
  double covarianceOfSquares() const { return m.central(2, 2) - m.central(2, 0) * m.central(0, 2); }

  // the estimate, and n times its variance
  double mean(const LinearMoments& linear, double factor) const {
    return m.meanX() - factor * (m.meanY() - linear.mean);
  }
  double meanNoise(double factor) const {
    return m.central(2, 0) - 2.0 * factor * m.central(1, 1) + factor * factor * m.central(0, 2);
  }
  double variance(const LinearMoments& linear, double factor) const {
    const double unbiased = n / (n - 1.0);
    return unbiased * m.central(2, 0) - factor * (unbiased * m.central(0, 2) - linear.sigma * linear.sigma);
  }
  double varianceNoise(double factor) const {
    return varianceOfSquareX() - 2.0 * factor * covarianceOfSquares() + factor * factor * varianceOfSquareY();
  }

  const JointMoments& m;
  double n;
};

}  // namespace

ControlledEstimate controlled(const JointMoments& even, const JointMoments& odd, const LinearMoments& linear,
                              double confidence) {
  const Half a(even), b(odd);
  const double n = a.n + b.n, share_a = a.n / n, share_b = b.n / n;
  JointMoments both = even;
  both.merge(odd);
  const Half all(both);

  ControlledEstimate estimate;
  const double mean_a = b.bestMeanFactor(), mean_b = a.bestMeanFactor();
  estimate.mean = share_a * a.mean(linear, mean_a) + share_b * b.mean(linear, mean_b);
  const double mean_noise =
      std::max(kRounding * all.m.central(2, 0),
               n / (n - 2.0) * (share_a * a.meanNoise(mean_a) + share_b * b.meanNoise(mean_b)));
  estimate.mean_interval =
      meanInterval(estimate.mean, std::sqrt(mean_noise / n), both.count() - 2, confidence);

  const double variance_a = b.bestVarianceFactor(), variance_b = a.bestVarianceFactor();
  const double variance = share_a * a.variance(linear, variance_a) + share_b * b.variance(linear, variance_b);
  const double variance_noise = std::max(
      kRounding * all.varianceOfSquareX(),
      n / (n - 2.0) * (share_a * a.varianceNoise(variance_a) + share_b * b.varianceNoise(variance_b)));
  estimate.sigma = std::sqrt(variance);
  estimate.sigma_interval =
      sigmaInterval(estimate.sigma, 0.5 * std::sqrt(variance_noise / n) / variance, confidence);

  estimate.mean_gain = all.m.central(2, 0) / mean_noise;
  estimate.sigma_gain = all.varianceOfSquareX() / variance_noise;
  estimate.correlation = all.m.central(1, 1) / std::sqrt(all.m.central(2, 0) * all.m.central(0, 2));
  return estimate;
}

}  // namespace cable_variation
