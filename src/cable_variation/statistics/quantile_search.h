#pragma once

#include <cstdint>

#include <boost/math/tools/toms748_solve.hpp>

namespace cable_variation {

/// Where in [low, high] the increasing function `cdf` reaches `probability`, to rounding error.
template <class Cdf>
double quantileOf(const Cdf& cdf, double probability, double low, double high) {
  const auto excess = [&](double x) { return cdf(x) - probability; };
  const double at_low = excess(low), at_high = excess(high);
  if (at_low >= 0.0) return low;
  if (at_high <= 0.0) return high;
  std::uintmax_t evaluations = 200;
  const auto bracket = boost::math::tools::toms748_solve(
      excess, low, high, at_low, at_high, boost::math::tools::eps_tolerance<double>(48), evaluations);
  return 0.5 * (bracket.first + bracket.second);
}

}  // namespace cable_variation
