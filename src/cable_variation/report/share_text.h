#pragma once

#include <algorithm>
#include <cmath>
#include <string>

#include <cable_variation/util/number_text.h>

namespace cable_variation {

/// A share of a whole for a person, "99.73 %": however close it is to the whole, with the digits that tell it
/// from that.
inline std::string shareText(double share) {
  constexpr int kDigits = 7, kMost = 15;
  constexpr double kHundred = 100.0;
  const double missing = 1.0 - share;
  int digits = kDigits;
  // two of the percentage before the point, and two of what is missing
  if (missing > 0.0)
    digits = std::clamp(4 + static_cast<int>(std::ceil(-std::log10(missing))), kDigits, kMost);
  return numberText(kHundred * share, digits) + " %";
}

}  // namespace cable_variation
