#include <cable_variation/harness/bend_radius.h>

#include <cmath>
#include <limits>
#include <stdexcept>

namespace cable_variation {

namespace {

/// Curvature of the quintic Hermite curve between two points at t in [0, 1], the
/// curve that CableShape::position() interpolates with.
double curvatureBetween(const ShapePoint& a, const ShapePoint& b, double t) {
  const double h = b.arc_length - a.arc_length;
  const double t2 = t * t, t3 = t2 * t, t4 = t3 * t;
  const Eigen::Vector3d chord = b.pose.position - a.pose.position;
  const Eigen::Vector3d first = (30.0 * t2 - 60.0 * t3 + 30.0 * t4) / h * chord +
                                (1.0 - 18.0 * t2 + 32.0 * t3 - 15.0 * t4) * a.tangent +
                                (-12.0 * t2 + 28.0 * t3 - 15.0 * t4) * b.tangent +
                                0.5 * h * (2.0 * t - 9.0 * t2 + 12.0 * t3 - 5.0 * t4) * a.bend +
                                0.5 * h * (3.0 * t2 - 8.0 * t3 + 5.0 * t4) * b.bend;
  const Eigen::Vector3d second = (60.0 * t - 180.0 * t2 + 120.0 * t3) / (h * h) * chord +
                                 (-36.0 * t + 96.0 * t2 - 60.0 * t3) / h * a.tangent +
                                 (-24.0 * t + 84.0 * t2 - 60.0 * t3) / h * b.tangent +
                                 0.5 * (2.0 - 18.0 * t + 36.0 * t2 - 20.0 * t3) * a.bend +
                                 0.5 * (6.0 * t - 24.0 * t2 + 20.0 * t3) * b.bend;
  return first.cross(second).norm() / std::pow(first.norm(), 3);
}

}  // namespace

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
    for (int k = 0; k <= kPlaces; ++k) {
      const double t = static_cast<double>(k) / kPlaces;
      const double here = curvatureBetween(a, b, t);
      if (here > curvature) {
        curvature = here;
        smallest = {1.0 / here, a.arc_length + t * (b.arc_length - a.arc_length)};
      }
    }
  }
  return smallest;
}

}  // namespace cable_variation
