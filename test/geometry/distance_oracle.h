#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

#include <cable_variation/geometry/mesh/triangle_mesh.h>
#include <cable_variation/geometry/tube_distance/centreline.h>
#include <cable_variation/math/pose.h>

/// Brute force for distances, by other formulae than the library's and in extended precision: every triangle,
/// every piece densely sampled, and golden sections about the best samples.
namespace cable_variation::test {

using Real = long double;
using RealVector = Eigen::Matrix<Real, 3, 1>;

inline Real segmentDistance(const RealVector& a, const RealVector& b, const RealVector& x) {
  const RealVector e = b - a;
  const Real squared = e.squaredNorm();
  const Real t = squared > 0 ? std::clamp<Real>(e.dot(x - a) / squared, 0, 1) : 0;
  return (a + t * e - x).norm();
}

/// By Gram's matrix: the foot in the triangle's plane, if it lies within; else the edges.
inline Real triangleDistance(const std::array<RealVector, 3>& corners, const RealVector& x) {
  const RealVector u = corners[1] - corners[0], v = corners[2] - corners[0], w = x - corners[0];
  Real smallest = std::numeric_limits<Real>::infinity();
  for (std::size_t i = 0; i < 3; ++i) {
    smallest = std::min(smallest, segmentDistance(corners[i], corners[(i + 1) % 3], x));
  }
  const Real uu = u.dot(u), uv = u.dot(v), vv = v.dot(v);
  const Real determinant = uu * vv - uv * uv;
  if (determinant > 1e-14L * uu * vv) {
    const Real s = (vv * u.dot(w) - uv * v.dot(w)) / determinant;
    const Real t = (uu * v.dot(w) - uv * u.dot(w)) / determinant;
    if (s >= 0 && t >= 0 && s + t <= 1) smallest = std::min(smallest, (w - s * u - t * v).norm());
  }
  return smallest;
}

/// The smallest of f over [a, b], which is searched about its lowest samples.
template <typename Function>
Real smallestOver(Real a, Real b, int samples, Function&& f) {
  std::vector<Real> values;
  for (int i = 0; i <= samples; ++i) values.push_back(f(a + (b - a) * i / samples));
  Real smallest = *std::min_element(values.begin(), values.end());
  // what is lower than its neighbours may be lower still between them
  const Real golden = (std::sqrt(Real(5)) - 1) / 2;
  for (int i = 0; i <= samples; ++i) {
    const auto k = static_cast<std::size_t>(i);
    if ((i > 0 && values[k - 1] < values[k]) || (i < samples && values[k + 1] < values[k])) continue;
    Real low = a + (b - a) * std::max(i - 1, 0) / samples,
         high = a + (b - a) * std::min(i + 1, samples) / samples;
    Real p = high - golden * (high - low), q = low + golden * (high - low);
    Real at_p = f(p), at_q = f(q);
    for (int step = 0; step < 32; ++step) {
      if (at_p < at_q) {
        high = q, q = p, at_q = at_p;
        p = high - golden * (high - low), at_p = f(p);
      } else {
        low = p, p = q, at_p = at_q;
        q = low + golden * (high - low), at_q = f(q);
      }
    }
    smallest = std::min({smallest, at_p, at_q});
  }
  return smallest;
}

inline RealVector curvePosition(const CurvePiece& curve, Real t) {
  RealVector sum = RealVector::Zero();
  for (std::size_t k = 6; k-- > 0;) sum = curve.coefficients()[k].cast<Real>() + t * sum;
  return sum;
}

inline Real radiusAt(const Centreline::Piece& piece, Real t) {
  return piece.start_radius + t * (Real(piece.end_radius) - piece.start_radius);
}

/// Lowers `smallest` to the least of f over [a, b], where f changes by no more than `rate` per unit: halves
/// what may hold less, then golden sections.
template <typename Function>
void lower(Real& smallest, Real a, Real at_a, Real b, Real at_b, Real rate, int halvings, const Function& f) {
  smallest = std::min({smallest, at_a, at_b});
  if ((at_a + at_b - rate * (b - a)) / 2 >= smallest) return;
  if (halvings == 0) {
    smallest = std::min(smallest, smallestOver(a, b, 2, f));
    return;
  }
  const Real middle = (a + b) / 2, at_middle = f(middle);
  lower(smallest, a, at_a, middle, at_middle, rate, halvings - 1, f);
  lower(smallest, middle, at_middle, b, at_b, rate, halvings - 1, f);
}

/// Distance of the surfaces, no inside test.
inline Real bruteForceDistance(const Centreline& cable, const TriangleMesh& mesh, const Pose& pose) {
  const Eigen::Quaternion<Real> turn = pose.orientation.cast<Real>().normalized();
  std::vector<RealVector> vertices;
  for (const Eigen::Vector3d& vertex : mesh.vertices) {
    vertices.push_back(pose.position.cast<Real>() + turn * vertex.cast<Real>());
  }
  Real smallest = std::numeric_limits<Real>::infinity();
  for (const auto& [a, b, c] : mesh.triangles) {
    const std::array<RealVector, 3> corners = {vertices[a], vertices[b], vertices[c]};
    for (const Centreline::Piece& piece : cable.pieces) {
      const auto value = [&](Real t) {
        return triangleDistance(corners, curvePosition(piece.curve, t)) - radiusAt(piece, t);
      };
      Real way = std::abs(Real(piece.end_radius) - piece.start_radius);
      for (std::size_t k = 1; k < 6; ++k) way += Real(k) * piece.curve.coefficients()[k].cast<Real>().norm();
      lower(smallest, 0, value(0), 1, value(1), way, 6, value);
    }
  }
  return smallest;
}

/// Random things of all sizes.
class Chance {
 public:
  explicit Chance(unsigned seed) : generator_(seed) {}
  double between(double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(generator_);
  }
  /// Evenly over the orders of magnitude.
  double size(double low, double high) { return std::exp(between(std::log(low), std::log(high))); }
  bool oneOf(int count) { return std::uniform_int_distribution<int>(1, count)(generator_) == 1; }
  std::size_t below(std::size_t count) {
    return std::uniform_int_distribution<std::size_t>(0, count - 1)(generator_);
  }
  Eigen::Vector3d inBox(double half) {
    return {between(-half, half), between(-half, half), between(-half, half)};
  }
  Eigen::Vector3d direction() {
    std::normal_distribution<double> normal;
    return Eigen::Vector3d(normal(generator_), normal(generator_), normal(generator_)).normalized();
  }
  Eigen::Quaterniond orientation() {
    return Eigen::Quaterniond(Eigen::AngleAxisd(between(0.0, M_PI), direction()));
  }

 private:
  std::mt19937_64 generator_;
};

/// A cable through random places: `pieces` of about `length` [m] each, that turn by about `turn` [rad].
inline Centreline randomCable(Chance& chance, std::size_t pieces, double length, double turn, double radius,
                              bool tapered) {
  Centreline cable;
  Eigen::Vector3d tangent = chance.direction();
  const auto bend = [&] {
    const Eigen::Vector3d any = chance.direction();
    return Eigen::Vector3d((any - any.dot(tangent) * tangent) * turn / length);
  };
  CurvePiece::End at{Eigen::Vector3d::Zero(), tangent, bend()};
  double s = 0.0, start_radius = radius;
  for (std::size_t i = 0; i < pieces; ++i) {
    const Eigen::Vector3d chord = length * (tangent + 0.5 * turn * chance.direction()).normalized();
    tangent = (tangent + turn * chance.direction()).normalized();
    const CurvePiece::End next{at.position + chord, tangent, bend()};
    const double end_radius = tapered ? radius * chance.between(0.3, 1.5) : radius;
    cable.pieces.push_back({CurvePiece(at, next, length), s, s + length, start_radius, end_radius});
    at = next;
    s += length;
    start_radius = end_radius;
  }
  return cable;
}

inline Centreline straightCable(const Eigen::Vector3d& from, const Eigen::Vector3d& to, double radius,
                                std::size_t pieces = 1) {
  Centreline cable;
  const double length = (to - from).norm() / static_cast<double>(pieces);
  const Eigen::Vector3d tangent = (to - from).normalized();
  for (std::size_t i = 0; i < pieces; ++i) {
    const double s = length * static_cast<double>(i);
    cable.pieces.push_back(
        {CurvePiece({from + s * tangent, tangent, Eigen::Vector3d::Zero()},
                    {from + (s + length) * tangent, tangent, Eigen::Vector3d::Zero()}, length),
         s, s + length, radius, radius});
  }
  return cable;
}

}  // namespace cable_variation::test
