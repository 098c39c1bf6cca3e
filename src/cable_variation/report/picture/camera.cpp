#include <cable_variation/report/picture/camera.h>

#include <algorithm>
#include <cmath>

namespace cable_variation {

using Eigen::Vector3d;

Vector3d Camera::project(const Vector3d& point) const {
  const Vector3d seen = axes * (point - centre);
  return {0.5 * width + pixels_per_metre * seen.x(), 0.5 * height - pixels_per_metre * seen.y(), seen.z()};
}

Eigen::Matrix3d cameraAxes(const Vector3d& direction, const Vector3d& up) {
  Vector3d right = up.cross(direction);
  if (right.norm() < 1e-6) right = direction.unitOrthogonal();  // from straight above or below
  right.normalize();
  Eigen::Matrix3d axes;
  axes << right.transpose(), direction.cross(right).transpose(), direction.transpose();
  return axes;
}

void frame(Camera& camera, const Eigen::Matrix3Xd& points, double margin, double least) {
  const Eigen::Matrix3Xd seen = camera.axes * points;
  const Vector3d low = seen.rowwise().minCoeff(), high = seen.rowwise().maxCoeff();
  camera.centre = camera.axes.transpose() * (0.5 * (low + high));
  const double room = 1.0 - 2.0 * margin;
  const Vector3d size = high - low;
  const double across = std::min(camera.width, camera.height);
  camera.pixels_per_metre = across / least;
  if (size.x() > 0.0)
    camera.pixels_per_metre = std::min(camera.pixels_per_metre, room * camera.width / size.x());
  if (size.y() > 0.0) {
    camera.pixels_per_metre = std::min(camera.pixels_per_metre, room * camera.height / size.y());
  }
}

}  // namespace cable_variation
