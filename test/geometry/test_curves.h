#pragma once

// Centrelines of known shape.

#include <cmath>
#include <functional>
#include <random>

#include <cable_variation/geometry/tube_distance/centreline.h>

namespace cable_variation::test {

/// An end of a curve piece as a function of arc length.
using Curve = std::function<CurvePiece::End(double)>;

inline Centreline centreline(const Curve& curve, double length, std::size_t pieces, double start_radius = 0.0,
                             double end_radius = 0.0) {
  Centreline line;
  for (std::size_t i = 0; i < pieces; ++i) {
    const double u = static_cast<double>(i) / static_cast<double>(pieces);
    const double v = static_cast<double>(i + 1) / static_cast<double>(pieces);
    line.pieces.push_back({CurvePiece(curve(u * length), curve(v * length), (v - u) * length), u * length,
                           v * length, start_radius + u * (end_radius - start_radius),
                           start_radius + v * (end_radius - start_radius)});
  }
  return line;
}

inline Curve straight(const Eigen::Vector3d& start, const Eigen::Vector3d& direction) {
  return [=](double s) {
    return CurvePiece::End{start + s * direction.normalized(), direction.normalized(),
                           Eigen::Vector3d::Zero()};
  };
}

/// About `centre` in the xy plane, from angle 0.
inline Curve circle(const Eigen::Vector3d& centre, double radius) {
  return [=](double s) {
    const double angle = s / radius;
    const Eigen::Vector3d out(std::cos(angle), std::sin(angle), 0.0);
    return CurvePiece::End{centre + radius * out, {-out.y(), out.x(), 0.0}, -out / radius};
  };
}

/// A curve that wanders like a routed cable: sines of a few wavelengths across a straight way.
inline Curve wandering(std::mt19937& generator, double length, double amplitude) {
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  Eigen::Matrix3d size, phase;
  for (int k = 0; k < 9; ++k) {
    size(k) = amplitude * uniform(generator);
    phase(k) = 3.0 * uniform(generator);
  }
  return [=](double s) {
    CurvePiece::End end{{s, 0.0, 0.0}, {1.0, 0.0, 0.0}, Eigen::Vector3d::Zero()};
    for (int k = 0; k < 3; ++k) {
      const double wave = (1.0 + k) * M_PI / length;
      for (int axis = 0; axis < 3; ++axis) {
        const double angle = wave * s + phase(k, axis), scale = size(k, axis) / (1.0 + k);
        end.position[axis] += scale * std::sin(angle);
        end.tangent[axis] += scale * wave * std::cos(angle);
        end.second_derivative[axis] -= scale * wave * wave * std::sin(angle);
      }
    }
    return end;
  };
}

}  // namespace cable_variation::test
