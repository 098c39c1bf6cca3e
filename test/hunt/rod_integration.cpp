#include <hunt/rod_integration.h>

#include <algorithm>
#include <cmath>

namespace cable_variation::hunt {
namespace {

using Eigen::Quaterniond;
using Eigen::Vector3d;
using Vector13 = Eigen::Matrix<double, 13, 1>;  // φ, q (x y z w), f, m

Vector13 pack(const RodState& state) {
  Vector13 y;
  y << state.position, state.orientation.coeffs(), state.force, state.moment;
  return y;
}

RodState unpack(const Vector13& y) {
  RodState state;
  state.position = y.head<3>();
  state.orientation.coeffs() = y.segment<4>(3).normalized();
  state.force = y.segment<3>(7);
  state.moment = y.tail<3>();
  return state;
}

class RodEquations {
 public:
  RodEquations(const RodProfile& profile, const Vector3d& gravity, double start, double end)
      : profile_(profile), gravity_(gravity), start_(start), end_(end) {}

  Vector13 slope(double s, const Vector13& y) const {
    // at a step of the section the side within counts
    const double inside = 1e-9 * (end_ - start_);
    const RodProperties rod = profile_.at(std::clamp(s, start_ + inside, end_ - inside));
    const RodState state = unpack(y);
    const Quaterniond& q = state.orientation;
    const Vector3d force = q.conjugate() * state.force, moment = q.conjugate() * state.moment;
    const Vector3d gamma = Vector3d::UnitX() + force.cwiseQuotient(rod.stiffness.head<3>());
    const Vector3d omega = rod.rest_curvature + moment.cwiseQuotient(rod.stiffness.tail<3>());
    const Vector3d tangent = q * gamma;
    const Quaterniond turning = q * Quaterniond(0.0, 0.5 * omega.x(), 0.5 * omega.y(), 0.5 * omega.z());
    Vector13 result;
    result << tangent, turning.coeffs(), -rod.mass_per_length * gravity_, -tangent.cross(state.force);
    return result;
  }

 private:
  const RodProfile& profile_;
  Vector3d gravity_;
  double start_, end_;
};

// What each component is measured against: a step's length, 1, the largest force, the largest moment.
double relativeError(const Vector13& error, const Vector13& y, double span) {
  const double force = y.segment<3>(7).norm() + 1e-12;
  const double moment = y.tail<3>().norm() + force * span + 1e-15;
  return std::max({error.head<3>().norm() / span, error.segment<4>(3).norm(),
                   error.segment<3>(7).norm() / force, error.tail<3>().norm() / moment});
}

}  // namespace

RodState integrateRod(const RodProfile& profile, const Vector3d& gravity, const RodState& from, double start,
                      double end, double tolerance, int* steps) {
  constexpr double kAt[7] = {0.0, 1.0 / 5, 3.0 / 10, 4.0 / 5, 8.0 / 9, 1.0, 1.0};
  constexpr double kA[7][6] = {{},
                               {1.0 / 5},
                               {3.0 / 40, 9.0 / 40},
                               {44.0 / 45, -56.0 / 15, 32.0 / 9},
                               {19372.0 / 6561, -25360.0 / 2187, 64448.0 / 6561, -212.0 / 729},
                               {9017.0 / 3168, -355.0 / 33, 46732.0 / 5247, 49.0 / 176, -5103.0 / 18656},
                               {35.0 / 384, 0.0, 500.0 / 1113, 125.0 / 192, -2187.0 / 6784, 11.0 / 84}};
  constexpr double kFourth[7] = {5179.0 / 57600,    0.0,          7571.0 / 16695, 393.0 / 640,
                                 -92097.0 / 339200, 187.0 / 2100, 1.0 / 40};
  constexpr int kMostSteps = 20000;
  const RodEquations rod(profile, gravity, start, end);
  const double span = end - start;
  Vector13 y = pack(from);
  double s = start, step = 0.1 * span;
  int taken = 0;
  while (s < end && taken < kMostSteps) {
    step = std::min(step, end - s);
    Vector13 k[7];
    Vector13 next = y;
    for (int i = 0; i < 7; ++i) {
      next = y;
      for (int j = 0; j < i; ++j) next += step * kA[i][j] * k[j];
      k[i] = rod.slope(s + kAt[i] * step, next);
    }
    Vector13 fourth = y;
    for (int i = 0; i < 7; ++i) fourth += step * kFourth[i] * k[i];
    const double error = relativeError(next - fourth, next, span);
    ++taken;
    if (error <= tolerance || step < 1e-9 * span) {
      s = end - s - step < 1e-12 * span ? end : s + step;
      y = next;
      y.segment<4>(3).normalize();
    }
    step *= std::clamp(0.9 * std::pow(tolerance / (error + 1e-300), 0.2), 0.2, 5.0);
  }
  if (steps != nullptr) *steps = taken;
  return unpack(y);
}

}  // namespace cable_variation::hunt
