#include <cable_variation/geometry/mesh/winding_number.h>

#include <cmath>

#include <Eigen/Geometry>

namespace cable_variation {

double windingNumber(const std::array<Eigen::Vector3d, 3>& triangle, const Eigen::Vector3d& x) {
  const Eigen::Vector3d a = triangle[0] - x, b = triangle[1] - x, c = triangle[2] - x;
  const double la = a.norm(), lb = b.norm(), lc = c.norm();
  const double volume = a.dot(b.cross(c));
  const double share = la * lb * lc + a.dot(b) * lc + b.dot(c) * la + c.dot(a) * lb;
  return volume == 0.0 && share <= 0.0 ? 0.0 : std::atan2(volume, share) / (2.0 * M_PI);
}

}  // namespace cable_variation
