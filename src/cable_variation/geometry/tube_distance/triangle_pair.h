#pragma once  // internal to geometry/

#include <cstdint>
#include <limits>
#include <optional>

#include <cable_variation/geometry/mesh/triangle_tree.h>

namespace cable_variation {

/// The closest points of two triangles, or of two sets of them.
struct TrianglePair {
  double distance = 0.0;  ///< [m]; 0: they touch or cross
  Eigen::Vector3d on_first, on_second;
  std::uint32_t first = 0, second = 0;  ///< triangles, of trees: in the leaves' order
};

/// To a few roundings of the coordinates, for triangles of any size and shape.
TrianglePair closestPoints(const SurfaceTriangle& first, const SurfaceTriangle& second);

/// Of all pairs. None if all are further than `at_most` [m] from each other.
std::optional<TrianglePair> closestPoints(const TriangleTree& first, const TriangleTree& second,
                                          double at_most = std::numeric_limits<double>::infinity());

/// Whether a triangle comes within `distance` [m] of some of the tree's.
bool comesWithin(const TriangleTree& tree, const SurfaceTriangle& triangle, double distance);

}  // namespace cable_variation
