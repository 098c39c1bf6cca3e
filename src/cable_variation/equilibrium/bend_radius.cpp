#include <cable_variation/equilibrium/bend_radius.h>

#include <limits>
#include <stdexcept>
#include <vector>

#include <cable_variation/math/extremum.h>

namespace cable_variation {

BendRadius smallestBendRadius(const CableShape& shape) {
  if (shape.points.size() < 2) {
    throw std::invalid_argument("bend radius of cable '" + shape.cable +
                                "': " + std::to_string(shape.points.size()) + " points, expected at least 2");
  }
  std::vector<CurvePiece> curves;
  std::vector<std::size_t> starts;
  for (std::size_t i = 0; i + 1 < shape.points.size(); ++i) {
    if (shape.points[i + 1].arc_length <= shape.points[i].arc_length) continue;  // the two points at a clip
    curves.push_back(curveBetween(shape.points[i], shape.points[i + 1]));
    starts.push_back(i);
  }
  BendRadius smallest{std::numeric_limits<double>::infinity(), shape.points.front().arc_length};
  if (curves.empty()) return smallest;
  const Extremum sharpest =
      largestAlong(curves.size(), [&](std::size_t piece, double t) { return curves[piece].curvature(t); });
  if (sharpest.value > 0.0) {
    const double start = shape.points[starts[sharpest.piece]].arc_length;
    const double end = shape.points[starts[sharpest.piece] + 1].arc_length;
    smallest = {1.0 / sharpest.value, start + sharpest.t * (end - start)};
  }
  return smallest;
}

}  // namespace cable_variation
