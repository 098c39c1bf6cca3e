#pragma once

#include <cmath>

namespace cable_variation::test {

/// A column without stretch that is clamped at its foot and bent over by a force onto its free end, along the
/// column and larger than the critical one (Euler; Love 1927, §262).
struct BentColumn {
  double along, aside;  ///< the end from the foot, of the column's length
};

/// @param ratio of the force to π²EI/4L², above 1
inline BentColumn bentColumn(double ratio) {
  const double wanted = 0.5 * M_PI * std::sqrt(ratio);  // K(k)
  double low = 0.0, high = 1.0;
  for (int i = 0; i < 60; ++i) {
    const double k = 0.5 * (low + high);
    (std::comp_ellint_1(k) < wanted ? low : high) = k;
  }
  return {2.0 * std::comp_ellint_2(low) / wanted - 1.0, 2.0 * low / wanted};
}

}  // namespace cable_variation::test
