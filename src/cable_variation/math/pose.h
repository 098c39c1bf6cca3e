#pragma once

#include <Eigen/Geometry>

namespace cable_variation {

/// A frame relative to a reference frame: the position of its origin [m] and
/// its orientation (unit quaternion taking the frame's axes to the reference).
struct Pose {
  Eigen::Vector3d position = Eigen::Vector3d::Zero();
  Eigen::Quaterniond orientation = Eigen::Quaterniond::Identity();

  /// The pose of a frame `inner`, given relative to this one, in the reference.
  Pose operator*(const Pose& inner) const {
    return {position + orientation * inner.position, (orientation * inner.orientation).normalized()};
  }

  /// A point given in this frame, expressed in the reference frame.
  Eigen::Vector3d operator*(const Eigen::Vector3d& point) const { return position + orientation * point; }

  Pose inverse() const {
    const Eigen::Quaterniond back = orientation.conjugate();
    return {-(back * position), back};
  }
};

}  // namespace cable_variation
