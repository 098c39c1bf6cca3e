#pragma once

#include <cmath>
#include <vector>

#include <Eigen/Geometry>

#include <cable_variation/geometry/tube_distance/tube.h>

namespace cable_variation::bench {

/// A ring about z of 2 * around * sides triangles: 200 mm, its tube 60 mm.
inline TriangleMesh ring(int around, int sides) {
  std::vector<Pose> path(static_cast<std::size_t>(around));
  for (int i = 0; i < around; ++i) {
    Pose& pose = path[static_cast<std::size_t>(i)];
    pose.orientation = Eigen::AngleAxisd(2.0 * M_PI * i / around, Eigen::Vector3d::UnitZ());
    pose.position = pose.orientation * Eigen::Vector3d(0.0, -0.2, 0.0);
  }
  return tubeMesh(path, 0.06, sides, true);
}

/// Its outermost point along y [m].
constexpr double kOutermost = 0.26;

}  // namespace cable_variation::bench
