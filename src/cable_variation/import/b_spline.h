#pragma once

#include <cstddef>
#include <vector>

#include <Eigen/Core>

namespace cable_variation {

/// A uniform B-spline over t from 0 to 1. de Boor, A Practical Guide to Splines, ch. IX and X.
class BSpline {
 public:
  /// Unclamped: knots 0, 1, ... n + d + 1 for n + 1 control points, and the curve runs from knot d to knot
  /// n + 1. Clamped: the knots at both ends are there d + 1 times, so that it runs from the first control
  /// point to the last.
  enum class Knots { unclamped, clamped };

  /// Throws std::invalid_argument for a degree below 1 or fewer than degree + 1 control points.
  BSpline(std::vector<Eigen::Vector3d> control_points, int degree, Knots knots);

  Eigen::Vector3d position(double t) const;
  Eigen::Vector3d first(double t) const;  ///< derivative over t
  /// Of the arc from `from` to `to`, by Gauss' rule of five points on so many parts of each polynomial: with
  /// eight, far below a micrometre for pieces of a metre.
  double length(double from = 0.0, double to = 1.0, int parts = 8) const;
  std::size_t polynomials() const { return control_points_.size() - static_cast<std::size_t>(degree_); }

 private:
  std::vector<Eigen::Vector3d> control_points_;
  int degree_;
  std::vector<double> knots_;
};

}  // namespace cable_variation
