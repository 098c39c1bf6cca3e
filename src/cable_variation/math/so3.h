#pragma once

#include <Eigen/Geometry>

/// The rotation group. Rotation vectors act from the right, in the body frame:
/// R exp([θ]×). Series replace the closed forms near zero, so every function is
/// smooth there.
namespace cable_variation::so3 {

/// [v]×, so that skew(v) w = v × w.
Eigen::Matrix3d skew(const Eigen::Vector3d& v);

/// exp([θ]×) as a unit quaternion.
Eigen::Quaterniond exp(const Eigen::Vector3d& rotation);

/// The rotation vector of q, of length at most π.
Eigen::Vector3d log(const Eigen::Quaterniond& q);

/// Right Jacobian: exp(θ + δ) = exp(θ) exp(J_r(θ) δ) to first order.
Eigen::Matrix3d rightJacobian(const Eigen::Vector3d& rotation);

/// The matrix M of the second-order part of that expansion against a covector g:
/// g · log(exp(-θ) exp(θ + δ)) = g · J_r δ + ½ δᵀ M δ + O(δ³). Symmetric.
Eigen::Matrix3d rightJacobianSlope(const Eigen::Vector3d& rotation, const Eigen::Vector3d& g);

/// The smallest rotation that takes unit vector `from` to unit vector `to`.
/// For opposite vectors, half a turn about an axis normal to them.
Eigen::Quaterniond smallestRotation(const Eigen::Vector3d& from, const Eigen::Vector3d& to);

}  // namespace cable_variation::so3
