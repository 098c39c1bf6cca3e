#pragma once

#include <array>
#include <cstddef>

#include <Eigen/Core>

namespace cable_variation {

/// A triangle made ready for nearest points, of any size and shape.
struct SurfaceTriangle {
  std::array<Eigen::Vector3d, 3> corners;
  /// Unit, to the side from which the corners run counter-clockwise; zero where the
  /// triangle is so thin (height under 1e-8 of its longest edge) that its edges are all of it.
  Eigen::Vector3d normal;

  SurfaceTriangle() = default;
  SurfaceTriangle(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c);
};

/// The point of a triangle that is nearest to some x.
struct NearestPoint {
  enum class On { face, edge, corner };
  On on = On::face;
  std::size_t number = 0;  ///< of the corner, or of the edge from that corner to the next
  Eigen::Vector3d point;
  double distance = 0.0;      ///< [m]
  Eigen::Vector3d direction;  ///< unit, from the point to x; on the surface itself: the triangle's normal
  Eigen::Vector3d edge;       ///< along the edge, any length, if on one
};

/// Foots are never rebuilt from barycentric coordinates, so slivers keep their
/// accuracy: a few roundings of the distance from x to the triangle's corners.
NearestPoint nearestPoint(const SurfaceTriangle& triangle, const Eigen::Vector3d& x);

/// Some unit vector at right angles to v, which need not be a unit vector.
Eigen::Vector3d someNormal(const Eigen::Vector3d& v);

}  // namespace cable_variation
