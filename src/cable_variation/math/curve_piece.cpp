#include <cable_variation/math/curve_piece.h>

#include <cmath>

#include <Eigen/Geometry>

namespace cable_variation {

CurvePiece::CurvePiece(const End& a, const End& b, double length) {
  const Eigen::Vector3d first_a = length * a.tangent, first_b = length * b.tangent;
  const Eigen::Vector3d second_a = length * length * a.second_derivative,
                        second_b = length * length * b.second_derivative;
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

std::array<Eigen::Vector3d, 6> CurvePiece::controlPoints(double from, double to) const {
  // powers of u, with t = from + (to - from) u: a Taylor shift by Horner's scheme, then a scaling
  std::array<Eigen::Vector3d, 6> power = coefficients_;
  if (from != 0.0) {
    for (std::size_t low = 0; low < 5; ++low) {
      for (std::size_t k = 5; k-- > low;) power[k] += from * power[k + 1];
    }
  }
  if (to - from != 1.0) {
    double scale = 1.0;
    for (Eigen::Vector3d& each : power) {
      each *= scale;
      scale *= to - from;
    }
  }
  // u^j = sum over i >= j of C(i, j) / C(5, j) times the i-th Bernstein polynomial
  constexpr double kShare[6][6] = {{1, 0, 0, 0, 0, 0},
                                   {1, 1.0 / 5, 0, 0, 0, 0},
                                   {1, 2.0 / 5, 1.0 / 10, 0, 0, 0},
                                   {1, 3.0 / 5, 3.0 / 10, 1.0 / 10, 0, 0},
                                   {1, 4.0 / 5, 6.0 / 10, 4.0 / 10, 1.0 / 5, 0},
                                   {1, 1, 1, 1, 1, 1}};
  std::array<Eigen::Vector3d, 6> points;
  for (std::size_t i = 0; i < 6; ++i) {
    points[i] = power[0];
    for (std::size_t j = 1; j <= i; ++j) points[i] += kShare[i][j] * power[j];
  }
  return points;
}

double CurvePiece::curvature(double t) const {
  const Eigen::Vector3d tangent = first(t);
  const double squared = tangent.squaredNorm();
  return tangent.cross(second(t)).norm() / (squared * std::sqrt(squared));
}

}  // namespace cable_variation
