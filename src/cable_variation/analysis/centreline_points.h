#pragma once

#include <cmath>
#include <cstddef>

namespace cable_variation {

/// How many points a cable's centreline is told by in an answer: at equal steps of at most 2 mm of arc
/// length; straight pieces between are 5 µm off at a bend radius of 100 mm. @param length of the cable [m]
inline std::size_t centrelineCount(double length) {
  constexpr double kStep = 0.002;  // [m]
  return static_cast<std::size_t>(std::ceil(length / kStep)) + 1;
}

}  // namespace cable_variation
