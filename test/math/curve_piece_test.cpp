// Bézier points of a part of a curve: the curve they make by de Casteljau's construction is that part.
#include <cable_variation/math/curve_piece.h>

#include <gtest/gtest.h>

namespace cable_variation {
namespace {

Eigen::Vector3d deCasteljau(std::array<Eigen::Vector3d, 6> points, double u) {
  for (std::size_t level = 5; level > 0; --level) {
    for (std::size_t i = 0; i < level; ++i) points[i] = (1.0 - u) * points[i] + u * points[i + 1];
  }
  return points[0];
}

TEST(curve_piece, control_points_make_the_same_curve) {
  const CurvePiece curve({{0.1, 0.2, 0.3}, {1.0, 0.1, -0.2}, {3.0, -8.0, 2.0}},
                         {{0.12, 0.21, 0.29}, {0.9, 0.3, 0.1}, {-5.0, 1.0, 4.0}}, 0.025);
  for (const auto& [from, to] : {std::pair{0.0, 1.0}, {0.0, 0.3}, {0.25, 0.75}, {0.9, 1.0}, {0.4, 0.4}}) {
    const auto points = curve.controlPoints(from, to);
    for (double u = 0.0; u <= 1.0; u += 0.125) {
      const Eigen::Vector3d there = curve.position(from + u * (to - from));
      EXPECT_NEAR((deCasteljau(points, u) - there).norm(), 0.0, 1e-15) << from << ' ' << to << ' ' << u;
    }
  }
}

}  // namespace
}  // namespace cable_variation
