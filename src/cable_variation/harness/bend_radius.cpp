#include <cable_variation/harness/bend_radius.h>

#include <cmath>
#include <limits>
#include <stdexcept>

namespace cable_variation {

BendRadius smallestBendRadius(const CableShape& shape) {
  if (shape.points.size() < 2) {
    throw std::invalid_argument("bend radius of cable '" + shape.cable +
                                "': " + std::to_string(shape.points.size()) + " points, expected at least 2");
  }
  BendRadius smallest{std::numeric_limits<double>::infinity(), shape.points.front().arc_length};
  for (std::size_t i = 1; i < shape.points.size(); ++i) {
    const ShapePoint& a = shape.points[i - 1];
    const ShapePoint& b = shape.points[i];
    // The two points at a clip: a jump of the tangent there is a kink of the shear angle, no bend.
    if (b.arc_length <= a.arc_length) continue;
    const double angle = std::atan2(a.tangent.cross(b.tangent).norm(), a.tangent.dot(b.tangent));
    const double radius = (b.pose.position - a.pose.position).norm() / angle;
    if (radius < smallest.radius) smallest = {radius, 0.5 * (a.arc_length + b.arc_length)};
  }
  return smallest;
}

}  // namespace cable_variation
