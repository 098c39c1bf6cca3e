#include <cable_variation/math/curve_piece.h>

#include <cmath>

#include <Eigen/Geometry>

namespace cable_variation {

CurvePiece::CurvePiece(const End& a, const End& b, double length) {
  const Eigen::Vector3d first_a = length * a.tangent, first_b = length * b.tangent;
  const Eigen::Vector3d second_a = length * length * a.bend, second_b = length * length * b.bend;
  const Eigen::Vector3d chord = b.position - a.position;
  coefficients_ = {a.position,
                   first_a,
                   0.5 * second_a,
                   10.0 * chord - 6.0 * first_a - 4.0 * first_b - 1.5 * second_a + 0.5 * second_b,
                   -15.0 * chord + 8.0 * first_a + 7.0 * first_b + 1.5 * second_a - second_b,
                   6.0 * chord - 3.0 * (first_a + first_b) + 0.5 * (second_b - second_a)};
}

Eigen::Vector3d CurvePiece::position(double t) const {
  Eigen::Vector3d sum = coefficients_[5];
  for (std::size_t k = 5; k-- > 0;) sum = coefficients_[k] + t * sum;
  return sum;
}

Eigen::Vector3d CurvePiece::first(double t) const {
  Eigen::Vector3d sum = 5.0 * coefficients_[5];
  for (std::size_t k = 5; k-- > 1;) sum = static_cast<double>(k) * coefficients_[k] + t * sum;
  return sum;
}

Eigen::Vector3d CurvePiece::second(double t) const {
  Eigen::Vector3d sum = 20.0 * coefficients_[5];
  for (std::size_t k = 5; k-- > 2;) sum = static_cast<double>(k * (k - 1)) * coefficients_[k] + t * sum;
  return sum;
}

double CurvePiece::curvature(double t) const {
  const Eigen::Vector3d tangent = first(t);
  return tangent.cross(second(t)).norm() / std::pow(tangent.norm(), 3);
}

}  // namespace cable_variation
