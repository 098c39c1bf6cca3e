#include <cable_variation/import/b_spline.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>
#include <string>

namespace cable_variation {
namespace {

// The value at x of the spline of these knots and control points, x within knots[span] and knots[span + 1]
// (de Boor's algorithm).
Eigen::Vector3d valueAt(const std::vector<Eigen::Vector3d>& control, const std::vector<double>& knots,
                        int degree, std::size_t span, double x) {
  const auto d = static_cast<std::size_t>(degree);
  std::vector<Eigen::Vector3d> points(control.begin() + static_cast<std::ptrdiff_t>(span - d),
                                      control.begin() + static_cast<std::ptrdiff_t>(span + 1));
  for (std::size_t r = 1; r <= d; ++r) {
    for (std::size_t j = d; j >= r; --j) {
      const std::size_t i = j + span - d;
      const double width = knots[i + d + 1 - r] - knots[i];
      const double a = width > 0.0 ? (x - knots[i]) / width : 0.0;
      points[j] = (1.0 - a) * points[j - 1] + a * points[j];
    }
  }
  return points[d];
}

// The polynomial that a parameter from 0 to 1 falls in.
std::size_t pieceOf(double t, std::size_t pieces) {
  const double at = std::clamp(t, 0.0, 1.0) * static_cast<double>(pieces);
  return std::min(static_cast<std::size_t>(at), pieces - 1);
}

}  // namespace

BSpline::BSpline(std::vector<Eigen::Vector3d> control_points, int degree, Knots knots)
    : control_points_(std::move(control_points)), degree_(degree) {
  if (degree < 1 || control_points_.size() <= static_cast<std::size_t>(degree)) {
    throw std::invalid_argument("a B-spline of degree " + std::to_string(degree) + " has " +
                                std::to_string(control_points_.size()) +
                                " control points; expected a degree of 1 at least and more points than that");
  }
  const std::size_t count = control_points_.size() + static_cast<std::size_t>(degree) + 1;
  const auto d = static_cast<double>(degree);
  const auto last = static_cast<double>(control_points_.size());  // the knot at the end
  for (std::size_t i = 0; i < count; ++i) {
    const auto knot = static_cast<double>(i);
    knots_.push_back(knots == Knots::unclamped ? knot : std::clamp(knot, d, last));
  }
}

Eigen::Vector3d BSpline::position(double t) const {
  const auto d = static_cast<std::size_t>(degree_);
  const double x =
      static_cast<double>(degree_) + std::clamp(t, 0.0, 1.0) * static_cast<double>(polynomials());
  return valueAt(control_points_, knots_, degree_, d + pieceOf(t, polynomials()), x);
}

Eigen::Vector3d BSpline::first(double t) const {
  // a spline of one degree less, over the same knots but the outermost
  const auto d = static_cast<std::size_t>(degree_);
  std::vector<Eigen::Vector3d> slopes;
  for (std::size_t i = 0; i + 1 < control_points_.size(); ++i) {
    const double width = knots_[i + d + 1] - knots_[i + 1];
    const double scale = width > 0.0 ? static_cast<double>(degree_) / width : 0.0;
    slopes.emplace_back(scale * (control_points_[i + 1] - control_points_[i]));
  }
  const std::vector<double> inner(knots_.begin() + 1, knots_.end() - 1);
  const auto pieces = static_cast<double>(polynomials());
  const double x = static_cast<double>(degree_) + std::clamp(t, 0.0, 1.0) * pieces;
  return pieces * valueAt(slopes, inner, degree_ - 1, d - 1 + pieceOf(t, polynomials()), x);
}

double BSpline::length(double from, double to, int parts) const {
  static constexpr std::array<double, 5> kAt{-0.906179845938664, -0.538469310105683, 0.0, 0.538469310105683,
                                             0.906179845938664};
  static constexpr std::array<double, 5> kWeight{0.236926885056189, 0.478628670499366, 0.568888888888889,
                                                 0.478628670499366, 0.236926885056189};
  const auto pieces = static_cast<double>(polynomials());
  double sum = 0.0;
  for (std::size_t piece = 0; piece < polynomials(); ++piece) {
    const double begin = std::max(from, static_cast<double>(piece) / pieces);
    const double end = std::min(to, static_cast<double>(piece + 1) / pieces);
    for (int part = 0; part < parts && begin < end; ++part) {
      const double half = 0.5 * (end - begin) / parts;
      const double middle = begin + (2 * part + 1) * half;
      for (std::size_t k = 0; k < kAt.size(); ++k)
        sum += kWeight[k] * half * first(middle + kAt[k] * half).norm();
    }
  }
  return sum;
}

}  // namespace cable_variation
