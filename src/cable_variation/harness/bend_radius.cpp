#include <cable_variation/harness/bend_radius.h>

#include <limits>
#include <stdexcept>

namespace cable_variation {

BendRadius smallestBendRadius(const CableShape& shape) {
  if (shape.points.size() < 2) {
    throw std::invalid_argument("bend radius of cable '" + shape.cable +
                                "': " + std::to_string(shape.points.size()) + " points, expected at least 2");
  }
  constexpr int kPlaces = 16;
  double curvature = 0.0;
  BendRadius smallest{std::numeric_limits<double>::infinity(), shape.points.front().arc_length};
  for (std::size_t i = 1; i < shape.points.size(); ++i) {
    const ShapePoint& a = shape.points[i - 1];
    const ShapePoint& b = shape.points[i];
    if (b.arc_length <= a.arc_length) continue;  // the two points at a clip
    const CurvePiece curve = curveBetween(a, b);
    for (int k = 0; k <= kPlaces; ++k) {
      const double t = static_cast<double>(k) / kPlaces;
      const double here = curve.curvature(t);
      if (here > curvature) {
        curvature = here;
        smallest = {1.0 / here, a.arc_length + t * (b.arc_length - a.arc_length)};
      }
    }
  }
  return smallest;
}

}  // namespace cable_variation
