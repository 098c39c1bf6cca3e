#pragma once  // internal to report/

#include <Eigen/Geometry>

namespace cable_variation {

/// Looks at the world by parallel projection: lengths across the view have one scale all over the picture.
struct Camera {
  Eigen::Matrix3d axes = Eigen::Matrix3d::Identity();  ///< rows: to the right, up, towards the viewer; world
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();    ///< in the middle of the picture [m, world]
  double pixels_per_metre = 1.0;
  double width = 0.0, height = 0.0;  ///< [px]

  /// x to the right and y downwards from the upper left corner [px], z towards the viewer [m].
  Eigen::Vector3d project(const Eigen::Vector3d& point) const;
};

/// Axes of a camera that stands in `direction` of what it looks at, `up` upright as far as that can be.
/// @param direction, up unit vectors, world
Eigen::Matrix3d cameraAxes(const Eigen::Vector3d& direction, const Eigen::Vector3d& up);

/// Makes `points` [m, world, a column each] fill the picture, but for `margin` (a share of its size) on every
/// side, at least `least` [m] across its smaller size. Width and height must be set.
void frame(Camera& camera, const Eigen::Matrix3Xd& points, double margin, double least);

}  // namespace cable_variation
