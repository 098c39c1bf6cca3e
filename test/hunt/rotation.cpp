#include <hunt/rotation.h>

#include <cmath>

namespace cable_variation::hunt {

using Eigen::Matrix3d;
using Eigen::Quaterniond;
using Eigen::Vector3d;

Matrix3d skew(const Vector3d& v) {
  Matrix3d m;
  m << 0.0, -v.z(), v.y(), v.z(), 0.0, -v.x(), -v.y(), v.x(), 0.0;
  return m;
}

Quaterniond rotationBy(const Vector3d& v) {
  const double angle = v.norm();
  // sin(x/2)/x to the fourth order where the quotient would lose figures
  const double factor = angle < 1e-3 ? 0.5 - angle * angle / 48.0 : std::sin(0.5 * angle) / angle;
  const Vector3d vec = factor * v;
  return Quaterniond(std::cos(0.5 * angle), vec.x(), vec.y(), vec.z());
}

Vector3d rotationVector(const Quaterniond& q) {
  const double sign = q.w() < 0.0 ? -1.0 : 1.0;
  const double w = sign * q.w(), n = q.vec().norm();
  // 2 atan2(n, w)/n to the second order likewise
  const double factor = n < 1e-5 * w ? 2.0 / w * (1.0 - n * n / (3.0 * w * w)) : 2.0 * std::atan2(n, w) / n;
  return factor * sign * q.vec();
}

Matrix3d rightJacobian(const Vector3d& theta) {
  const double t = theta.norm(), t2 = t * t;
  const double a = t < 1e-2 ? 0.5 - t2 / 24.0 : (1.0 - std::cos(t)) / t2;
  const double b = t < 1e-2 ? 1.0 / 6.0 - t2 / 120.0 : (t - std::sin(t)) / (t2 * t);
  const Matrix3d k = skew(theta);
  return Matrix3d::Identity() - a * k + b * k * k;
}

Quaterniond shortestArc(const Vector3d& from, const Vector3d& to) {
  return Quaterniond::FromTwoVectors(from, to);
}

}  // namespace cable_variation::hunt
