#pragma once

#include <Eigen/Geometry>

namespace cable_variation::hunt {

/// [v]×, so that skew(v) w = v × w.
Eigen::Matrix3d skew(const Eigen::Vector3d& v);

/// The rotation by |v| about v.
Eigen::Quaterniond rotationBy(const Eigen::Vector3d& v);

/// The rotation vector of q, of length at most π.
Eigen::Vector3d rotationVector(const Eigen::Quaterniond& q);

/// J with exp(θ + δ) = exp(θ) exp(J δ) to first order.
Eigen::Matrix3d rightJacobian(const Eigen::Vector3d& theta);

/// The shortest rotation that takes the direction `from` to the direction `to`.
Eigen::Quaterniond shortestArc(const Eigen::Vector3d& from, const Eigen::Vector3d& to);

}  // namespace cable_variation::hunt
