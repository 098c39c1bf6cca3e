#pragma once

// Planar elasticas by shooting: what contact is compared with. Nothing of it is shared with the solver.

#include <array>
#include <cmath>
#include <functional>

#include <Eigen/LU>

namespace cable_variation::test {

/// A state along an inextensible planar rod: x, z, angle, moment.
using Planar = Eigen::Vector4d;

/// Runge-Kutta's classical method from `state` over `length` in `steps`.
inline Planar integrate(Planar state, double length, int steps,
                        const std::function<Planar(double, const Planar&)>& rate) {
  const double h = length / steps;
  for (int i = 0; i < steps; ++i) {
    const double s = i * h;
    const Planar a = rate(s, state), b = rate(s + 0.5 * h, state + 0.5 * h * a);
    const Planar c = rate(s + 0.5 * h, state + 0.5 * h * b), d = rate(s + h, state + h * c);
    state += h / 6.0 * (a + 2.0 * b + 2.0 * c + d);
  }
  return state;
}

/// The root of `f`, Newton's method with differences from `x`; columns are scaled by `scale`.
template <int kSize>
Eigen::Matrix<double, kSize, 1> rootOf(
    const std::function<Eigen::Matrix<double, kSize, 1>(const Eigen::Matrix<double, kSize, 1>&)>& f,
    Eigen::Matrix<double, kSize, 1> x, const Eigen::Matrix<double, kSize, 1>& scale) {
  for (int round = 0; round < 60; ++round) {
    const Eigen::Matrix<double, kSize, 1> value = f(x);
    Eigen::Matrix<double, kSize, kSize> slope;
    for (int k = 0; k < kSize; ++k) {
      Eigen::Matrix<double, kSize, 1> aside = x;
      const double step = 1e-6 * scale[k];
      aside[k] += step;
      slope.col(k) = (f(aside) - value) / step;
    }
    const Eigen::Matrix<double, kSize, 1> step = slope.partialPivLu().solve(value);
    x -= step;
    if (step.cwiseQuotient(scale).cwiseAbs().maxCoeff() < 1e-13) break;
  }
  return x;
}

}  // namespace cable_variation::test
