#include <cmath>
#include <sstream>
#include <stdexcept>

#include <Eigen/Geometry>
#include <unsupported/Eigen/Splines>

#include <cable_variation/math/so3.h>
#include <cable_variation/rod/cable.h>

namespace cable_variation {
namespace {

constexpr int kSamples = 400;

}  // namespace

std::vector<RestCurvatureAt> restCurvatureThrough(const std::vector<Eigen::Vector3d>& points, double length) {
  std::ostringstream text;
  if (points.size() < 3) {
    text << "rest shape has " << points.size() << " points, expected at least 3";
    throw std::invalid_argument(text.str());
  }
  Eigen::Matrix3Xd control(3, points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (!points[i].allFinite()) {
      text << "rest shape point " << i << " is not finite";
      throw std::invalid_argument(text.str());
    }
    if (i > 0 && (points[i] - points[i - 1]).norm() < 1e-6 * length) {
      text << "rest shape points " << i - 1 << " and " << i << " coincide, expected a distance between them";
      throw std::invalid_argument(text.str());
    }
    control.col(static_cast<Eigen::Index>(i)) = points[i];
  }
  using Spline = Eigen::Spline<double, 3>;
  const int degree = points.size() == 3 ? 2 : 3;
  Spline::KnotVectorType parameters;
  Eigen::ChordLengths(control, parameters);
  const Spline spline = Eigen::SplineFitting<Spline>::Interpolate(control, degree, parameters);

  std::vector<RestCurvatureAt> knots;
  Eigen::Vector3d tangent = spline.derivatives(0.0, 1).col(1).matrix().normalized();
  Eigen::Quaterniond frame = so3::smallestRotation(Eigen::Vector3d::UnitX(), tangent);
  double arc_length = 0.0;
  for (int i = 0; i <= kSamples; ++i) {
    const double u = static_cast<double>(i) / kSamples;
    const auto derivatives = spline.derivatives(u, 2);
    const Eigen::Vector3d first = derivatives.col(1).matrix();
    const Eigen::Vector3d second = derivatives.col(2).matrix();
    const double speed = first.norm();
    if (i > 0) {
      // length of the piece by Gauss' two-point rule
      const double h = 1.0 / kSamples;
      for (double at : {0.5 - 0.5 / std::sqrt(3.0), 0.5 + 0.5 / std::sqrt(3.0)}) {
        arc_length += 0.5 * h * spline.derivatives(u - h + at * h, 1).col(1).matrix().norm();
      }
    }
    const Eigen::Vector3d next_tangent = first / speed;
    frame = so3::smallestRotation(tangent, next_tangent) * frame;
    tangent = next_tangent;
    // a rotation-minimising frame has no torsion: Ω = t × t' in the frame
    const Eigen::Vector3d bending = first.cross(second) / (speed * speed * speed);
    knots.push_back({arc_length, frame.conjugate() * bending});
    knots.back().curvature.x() = 0.0;
  }
  if (std::abs(arc_length - length) > 0.01 * length) {
    text << "rest shape is a curve of length " << arc_length << " m, expected the cable's length of "
         << length << " m within 1 %";
    throw std::invalid_argument(text.str());
  }
  const double scale = length / arc_length;
  for (RestCurvatureAt& knot : knots) {
    knot.arc_length *= scale;
    knot.curvature /= scale;
  }
  return knots;
}

}  // namespace cable_variation
