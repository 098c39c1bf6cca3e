#include <cable_variation/harness/bend_radius.h>

#include <cmath>
#include <limits>
#include <stdexcept>

namespace cable_variation {

BendRadius smallestBendRadius(const CableShape& shape) {
  if (shape.points.empty()) {
    throw std::invalid_argument("bend radius of cable '" + shape.cable + "': the shape has no points");
  }
  double curvature = 0.0;
  BendRadius smallest{std::numeric_limits<double>::infinity(), shape.points.front().arc_length};
  for (const ShapePoint& point : shape.points) {
    const double here = point.tangent.cross(point.bend).norm() / std::pow(point.tangent.norm(), 3);
    if (here > curvature) {
      curvature = here;
      smallest = {1.0 / here, point.arc_length};
    }
  }
  return smallest;
}

}  // namespace cable_variation
