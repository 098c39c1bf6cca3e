#pragma once

#include <Eigen/Core>

namespace cable_variation {

/// A place of a surface that is nearest to a point x among those about it.
struct SurfacePlace {
  Eigen::Vector3d point;      ///< on the surface [m]
  Eigen::Vector3d direction;  ///< unit, from the point to x: the derivative of the distance by x
  double distance = 0.0;      ///< [m]
  Eigen::Matrix3d curvature = Eigen::Matrix3d::Zero();  ///< second derivative of the distance by x [1/m]
};

}  // namespace cable_variation
