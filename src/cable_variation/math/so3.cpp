#include <cable_variation/math/so3.h>

#include <cmath>

namespace cable_variation::so3 {
namespace {

// J_r = I - a [θ]× + b [θ]×², and the derivatives of a and b over the angle, each divided by the angle.
struct Coefficients {
  double a, b, a_slope, b_slope;
};

Coefficients coefficients(double angle) {
  const double t2 = angle * angle;
  if (angle < 0.05) {
    return {0.5 - t2 / 24.0 + t2 * t2 / 720.0, 1.0 / 6.0 - t2 / 120.0 + t2 * t2 / 5040.0,
            -1.0 / 12.0 + t2 / 180.0 - t2 * t2 / 6720.0, -1.0 / 60.0 + t2 / 1260.0 - t2 * t2 / 60480.0};
  }
  const double s = std::sin(angle);
  const double c = std::cos(angle);
  const double t4 = t2 * t2;
  return {(1.0 - c) / t2, (angle - s) / (t2 * angle), (angle * s - 2.0 * (1.0 - c)) / t4,
          (3.0 * s - angle * (2.0 + c)) / (t4 * angle)};
}

}  // namespace

Eigen::Matrix3d skew(const Eigen::Vector3d& v) {
  return (Eigen::Matrix3d() << 0.0, -v.z(), v.y(), v.z(), 0.0, -v.x(), -v.y(), v.x(), 0.0).finished();
}

Eigen::Quaterniond exp(const Eigen::Vector3d& rotation) {
  const double half2 = 0.25 * rotation.squaredNorm();
  if (half2 < 1e-6) {
    const double w = 1.0 - 0.5 * half2 + half2 * half2 / 24.0;
    const Eigen::Vector3d v = 0.5 * (1.0 - half2 / 6.0 + half2 * half2 / 120.0) * rotation;
    return {w, v.x(), v.y(), v.z()};
  }
  const double half = std::sqrt(half2);
  const Eigen::Vector3d v = 0.5 * (std::sin(half) / half) * rotation;
  return {std::cos(half), v.x(), v.y(), v.z()};
}

Eigen::Vector3d log(const Eigen::Quaterniond& q) {
  const Eigen::Vector3d v = q.w() < 0.0 ? Eigen::Vector3d(-q.vec()) : Eigen::Vector3d(q.vec());
  const double w = std::abs(q.w());
  const double n = v.norm();
  if (n < 1e-3 * w) {
    const double r2 = (n / w) * (n / w);
    return (2.0 / w) * (1.0 - r2 / 3.0 + r2 * r2 / 5.0) * v;
  }
  return (2.0 * std::atan2(n, w) / n) * v;
}

Eigen::Matrix3d rightJacobian(const Eigen::Vector3d& rotation) {
  const Coefficients k = coefficients(rotation.norm());
  const Eigen::Matrix3d S = skew(rotation);
  return Eigen::Matrix3d::Identity() - k.a * S + k.b * S * S;
}

Eigen::Matrix3d rightJacobianSlope(const Eigen::Vector3d& rotation, const Eigen::Vector3d& g) {
  // d/dε J_r(θ + εδ) δ = -(a'/|θ|)(θ·δ) θ×δ + (b'/|θ|)(θ·δ) θ×(θ×δ) + b δ×(θ×δ)
  const Coefficients k = coefficients(rotation.norm());
  const Eigen::Vector3d g_cross = g.cross(rotation);         // g·(θ×δ) = δ·(g×θ)
  const Eigen::Vector3d g_cross2 = g_cross.cross(rotation);  // g·(θ×(θ×δ))
  const Eigen::Vector3d along = -k.a_slope * g_cross + k.b_slope * g_cross2;
  Eigen::Matrix3d m = rotation * along.transpose();
  // g·(δ×(θ×δ)) = |δ|² g·θ - (δ·θ)(g·δ)
  m += k.b * (g.dot(rotation) * Eigen::Matrix3d::Identity() - rotation * g.transpose());
  return 0.5 * (m + m.transpose());
}

Eigen::Quaterniond smallestRotation(const Eigen::Vector3d& from, const Eigen::Vector3d& to) {
  const double c = from.dot(to);
  if (c > -1.0 + 1e-12) {
    const Eigen::Vector3d v = from.cross(to);
    return Eigen::Quaterniond(1.0 + c, v.x(), v.y(), v.z()).normalized();
  }
  const Eigen::Vector3d axis = from.unitOrthogonal();
  return {0.0, axis.x(), axis.y(), axis.z()};
}

}  // namespace cable_variation::so3
