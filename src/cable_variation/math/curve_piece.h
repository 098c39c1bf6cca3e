#pragma once

#include <array>

#include <Eigen/Core>

namespace cable_variation {

/// A curve through two points with given first and second derivatives there: the
/// quintic Hermite polynomial, over t from 0 to 1.
class CurvePiece {
 public:
  /// An end: position [m], and its derivatives over arc length [1], [1/m].
  struct End {
    Eigen::Vector3d position, tangent, second_derivative;
  };

  /// From a to b over an arc length of `length` > 0 [m].
  CurvePiece(const End& a, const End& b, double length);

  Eigen::Vector3d position(double t) const;  ///< [m]
  Eigen::Vector3d first(double t) const;     ///< derivative over t [m]
  Eigen::Vector3d second(double t) const;    ///< second derivative over t [m]
  double curvature(double t) const;          ///< [1/m]
  /// Bézier points of the part between `from` and `to`: that part lies in their hull [m].
  std::array<Eigen::Vector3d, 6> controlPoints(double from, double to) const;
  /// Of the powers of t from 0 to 5 [m].
  const std::array<Eigen::Vector3d, 6>& coefficients() const { return coefficients_; }

 private:
  std::array<Eigen::Vector3d, 6> coefficients_;
};

}  // namespace cable_variation
