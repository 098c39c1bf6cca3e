#pragma once

#include <cstddef>
#include <vector>

#include <cable_variation/equilibrium/equilibrium.h>

namespace cable_variation {

/// Where the centrelines of two shapes of a harness are furthest apart, section by section.
struct ShapeDistance {
  double distance = 0.0;    ///< [m]
  std::size_t cable = 0;    ///< index
  double arc_length = 0.0;  ///< on it [m]
};

/// @param places of each cable that are looked at, at equal steps of arc length, ends included; at least 2
ShapeDistance shapeDistance(const std::vector<CableShape>& a, const std::vector<CableShape>& b,
                            std::size_t places);

}  // namespace cable_variation
