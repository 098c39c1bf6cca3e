#pragma once

#include <cable_variation/equilibrium/equilibrium.h>

namespace cable_variation {

/// How tightly a cable is bent where it is bent the most.
struct BendRadius {
  double radius = 0.0;      ///< of the centreline [m]; infinite: straight
  double arc_length = 0.0;  ///< where that is [m]
};

/// The smallest radius of curvature of the centreline, between the shape's points too. Throws
/// std::invalid_argument for fewer than two points.
BendRadius smallestBendRadius(const CableShape& shape);

}  // namespace cable_variation
