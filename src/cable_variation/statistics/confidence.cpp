#include <cable_variation/statistics/confidence.h>

#include <cmath>
#include <stdexcept>

#include <boost/math/distributions/beta.hpp>
#include <boost/math/distributions/students_t.hpp>

#include <cable_variation/math/normal.h>
#include <cable_variation/util/quantity.h>

namespace cable_variation {

void checkConfidence(double confidence) {
  if (confidence > 0.0 && confidence < 1.0) return;
  throw std::invalid_argument("confidence " + shortNumber(confidence) + "; expected between 0 and 1");
}

double normalReach(double confidence) { return normalScore(0.5 * (1.0 + confidence)); }

ConfidenceInterval meanInterval(double mean, double standard_error, std::uint64_t freedoms,
                                double confidence) {
  const boost::math::students_t t(static_cast<double>(freedoms));
  const double reach = boost::math::quantile(t, 0.5 * (1.0 + confidence)) * standard_error;
  return {mean - reach, mean + reach};
}

ConfidenceInterval sigmaInterval(double sigma, double log_standard_error, double confidence) {
  const double factor = std::exp(normalReach(confidence) * log_standard_error);
  return {sigma / factor, sigma * factor};
}

ConfidenceInterval shareInterval(std::uint64_t hits, std::uint64_t trials, double confidence) {
  const auto k = static_cast<double>(hits), n = static_cast<double>(trials);
  const double tail = 0.5 * (1.0 - confidence);
  ConfidenceInterval interval{0.0, 1.0};
  using Beta = boost::math::beta_distribution<>;
  if (hits > 0) interval.low = boost::math::quantile(Beta(k, n - k + 1.0), tail);
  if (hits < trials) interval.high = boost::math::quantile(Beta(k + 1.0, n - k), 1.0 - tail);
  return interval;
}

double shareUpperBound(std::uint64_t hits, std::uint64_t trials, double confidence) {
  if (hits >= trials) return 1.0;
  const boost::math::beta_distribution<> beta(static_cast<double>(hits) + 1.0,
                                              static_cast<double>(trials - hits));
  return boost::math::quantile(beta, confidence);
}

}  // namespace cable_variation
