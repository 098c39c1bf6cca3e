#include <hunt/discrete_element.h>

#include <hunt/rotation.h>

namespace cable_variation::hunt {

using Eigen::Matrix3d;
using Eigen::Vector3d;

StrainEnergy::StrainEnergy(const Vector3d& v, double length, const Vector3d& stiffness,
                           const Vector3d& stiffness_slope, const Vector3d& rest, const Vector3d& rest_slope)
    : strain(v / length - rest), stress(stiffness.cwiseProduct(strain)) {
  const Vector3d per_length = v / length;  // -h times the strain's derivative by h
  const Vector3d k_slope = stiffness_slope.cwiseProduct(strain);
  const Vector3d k_rest = stiffness.cwiseProduct(rest_slope);
  energy = 0.5 * length * strain.dot(stress);
  by_length = 0.5 * strain.dot(stress) - stress.dot(per_length);
  by_place = length * (0.5 * strain.dot(k_slope) - stress.dot(rest_slope));
  by_v_length = -stiffness.cwiseProduct(per_length) / length;
  by_v_place = k_slope - k_rest;
  by_length_length = per_length.dot(stiffness.cwiseProduct(per_length)) / length;
  by_length_place = 0.5 * strain.dot(k_slope) - stress.dot(rest_slope) - by_v_place.dot(per_length);
  by_place_place = length * (rest_slope.dot(k_rest) - 2.0 * k_slope.dot(rest_slope));
}

StretchVector::StretchVector(const Vector3d& from, const Vector3d& to, const Eigen::Quaterniond& segment)
    : value(segment.conjugate() * (to - from)), transposed_(segment.toRotationMatrix().transpose()) {}

// exp(-θ) v = v - θ×v + ½ θ×(θ×v)
StretchVector::First StretchVector::first() const {
  First result;
  result << -transposed_, transposed_, skew(value);
  return result;
}

StretchVector::Second StretchVector::second(const Vector3d& n) const {
  Second result = Second::Zero();
  const Matrix3d turned = skew(n) * transposed_;  // -n·(θ×Rᵀd) = θ·(n×Rᵀd)
  result.block<3, 3>(6, 0) = -turned;
  result.block<3, 3>(6, 3) = turned;
  result.block<3, 3>(0, 6) = -turned.transpose();
  result.block<3, 3>(3, 6) = turned.transpose();
  result.block<3, 3>(6, 6) =
      0.5 * (value * n.transpose() + n * value.transpose()) - n.dot(value) * Matrix3d::Identity();
  return result;
}

CurvatureVector::CurvatureVector(const Eigen::Quaterniond& a, const Eigen::Quaterniond& b) {
  const Eigen::Quaterniond between = a.conjugate() * b;
  const double sign = between.w() < 0.0 ? -1.0 : 1.0;
  w_ = sign * between.w();
  p_ = sign * between.vec();
  value = 2.0 * p_;
}

// The frames turn by exp(θ) = (1 - |θ|²/8, θ/2) to second order.
CurvatureVector::First CurvatureVector::first() const {
  First result;
  result << skew(p_) - w_ * Matrix3d::Identity(), skew(p_) + w_ * Matrix3d::Identity();
  return result;
}

CurvatureVector::Second CurvatureVector::second(const Vector3d& m) const {
  const double along = m.dot(p_);
  const Matrix3d identity = Matrix3d::Identity();
  const Matrix3d mixed = -0.5 * (along * identity - p_ * m.transpose() - m * p_.transpose() - w_ * skew(m));
  Second result;
  result << -0.5 * along * identity, mixed, mixed.transpose(), -0.5 * along * identity;
  return result;
}

}  // namespace cable_variation::hunt
