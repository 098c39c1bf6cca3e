#pragma once

#include <cmath>
#include <string>

#include <Eigen/Core>

#include <cable_variation/util/number_text.h>

namespace cable_variation::validation {

/// The share that `found` is off, in per cent.
inline std::string shareOff(double found, double expected) {
  return numberText(100.0 * std::abs(found / expected - 1.0), 2) + " %";
}

/// "(x, y, z)".
inline std::string pointText(const Eigen::Vector3d& point, int digits) {
  std::string text;
  for (int i = 0; i < 3; ++i) text += (i > 0 ? ", " : "(") + numberText(point[i], digits);
  return text + ")";
}

}  // namespace cable_variation::validation
