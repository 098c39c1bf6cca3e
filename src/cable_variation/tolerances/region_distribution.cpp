#include <cable_variation/tolerances/region_distribution.h>

#include <algorithm>
#include <cmath>

#include <boost/math/distributions/beta.hpp>
#include <boost/math/quadrature/gauss_kronrod.hpp>
#include <boost/math/special_functions/gamma.hpp>

#include <cable_variation/statistics/quantile_search.h>

namespace cable_variation {
namespace {

// The share of a chi-squared variable of `freedoms` degrees of freedom below x.
double chiSquaredShare(int freedoms, double x) { return boost::math::gamma_p(0.5 * freedoms, 0.5 * x); }

}  // namespace

RegionDistribution::RegionDistribution(int dimensions, double radius, double sigma)
    : dimensions_(dimensions), radius_(radius), sigma_(sigma == 0.0 ? 0.0 : std::max(sigma, kEven)) {}

double RegionDistribution::standardDeviation() const {
  if (sigma_ == 0.0) return radius_ / std::sqrt(dimensions_ + 2.0);
  const double k2 = sigma_ * sigma_;
  return radius_ / sigma_ *
         std::sqrt(chiSquaredShare(dimensions_ + 2, k2) / chiSquaredShare(dimensions_, k2));
}

// Evenly, the density (1 - u²)^((d - 1)/2) of u = x / r is a beta distribution's. Normal, z = k u has
// exp(-z²/2) times the share of the other coordinates within the ball; z = k sin t makes it smooth at the
// ends.
double RegionDistribution::cdf(double deviation) const {
  const double u = deviation / radius_;
  if (u <= -1.0) return 0.0;
  if (u >= 1.0) return 1.0;
  if (sigma_ == 0.0) {
    const double shape = 0.5 * (dimensions_ + 1);
    return boost::math::cdf(boost::math::beta_distribution<>(shape, shape), 0.5 * (1.0 + u));
  }
  const double k = sigma_;
  const auto density = [&](double t) {
    const double z = k * std::sin(t), rest = k * std::cos(t);
    return std::exp(-0.5 * z * z) * chiSquaredShare(dimensions_ - 1, rest * rest) * rest;
  };
  using Quadrature = boost::math::quadrature::gauss_kronrod<double, 31>;
  constexpr unsigned kDepth = 8;
  constexpr double kRelativeError = 1e-12;
  constexpr double kNothing =
      40.0;  // standard deviations beyond which there is none: a wide region's outside
  const double end = std::asin(std::min(std::abs(u), kNothing / k));
  const double part = u == 0.0 ? 0.0 : Quadrature::integrate(density, 0.0, end, kDepth, kRelativeError);
  const double whole = std::sqrt(2.0 * M_PI) * chiSquaredShare(dimensions_, k * k);
  return 0.5 + std::copysign(part / whole, u);
}

double RegionDistribution::quantile(double probability) const {
  return quantileOf([this](double x) { return cdf(x); }, probability, -radius_, radius_);
}

}  // namespace cable_variation
