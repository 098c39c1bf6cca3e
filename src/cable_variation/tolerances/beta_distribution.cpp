#include <cable_variation/tolerances/beta_distribution.h>

#include <algorithm>
#include <cmath>

#include <boost/math/special_functions/beta.hpp>

#include <cable_variation/statistics/quantile_search.h>

namespace cable_variation {
namespace {

// A logarithm below those of all doubles.
double logarithm(double share) {
  constexpr double kNothing = -800.0;
  return share > 0.0 ? std::log(share) : kNothing;
}

// Of the way from one limit to the other, by the logarithm of the ratio of its parts.
double partOf(double logit) { return 1.0 / (1.0 + std::exp(-logit)); }

}  // namespace

BetaDistribution::BetaDistribution(double low, double high, double alpha, double beta)
    : low_(low), high_(high), alpha_(alpha), beta_(beta) {}

// α/(α + β) and αβ/((α + β)² (α + β + 1)), for parameters of any size.
double BetaDistribution::mean() const {
  const double low_share = 1.0 / (1.0 + alpha_ / beta_), high_share = 1.0 / (1.0 + beta_ / alpha_);
  return low_share * low_ + high_share * high_;
}

double BetaDistribution::standardDeviation() const {
  const double low_share = 1.0 / (1.0 + alpha_ / beta_), high_share = 1.0 / (1.0 + beta_ / alpha_);
  return (high_ - low_) * std::sqrt(low_share * high_share / (alpha_ + beta_ + 1.0));
}

double BetaDistribution::cdf(double deviation) const {
  const double below = (deviation - low_) / (high_ - low_), above = (high_ - deviation) / (high_ - low_);
  if (below <= 0.0) return 0.0;
  if (above <= 0.0) return 1.0;
  return below < above ? boost::math::ibeta(alpha_, beta_, below) : boost::math::ibetac(beta_, alpha_, above);
}

double BetaDistribution::quantile(double probability) const {
  constexpr double kReach =
      700.0;  // beyond, doubles of parts are no longer whole: what lies there is a limit
  const bool lower = probability <= 0.5;
  const double wanted = lower ? std::log(probability) : std::log1p(-probability);
  // of the share below, increasing; of that above, negative, for it falls
  const auto share = [&](double logit) {
    const double below = partOf(logit), above = partOf(-logit);
    if (lower) {
      return logarithm(below < above ? boost::math::ibeta(alpha_, beta_, below)
                                     : boost::math::ibetac(beta_, alpha_, above));
    }
    return -logarithm(below < above ? boost::math::ibetac(alpha_, beta_, below)
                                    : boost::math::ibeta(beta_, alpha_, above));
  };
  const double logit = quantileOf(share, lower ? wanted : -wanted, -kReach, kReach);
  const double place =
      logit < 0.0 ? low_ + (high_ - low_) * partOf(logit) : high_ - (high_ - low_) * partOf(-logit);
  return std::clamp(place, low_, high_);
}

}  // namespace cable_variation
