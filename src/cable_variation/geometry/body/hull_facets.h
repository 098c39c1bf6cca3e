#pragma once  // internal to geometry/

#include <array>
#include <cstdint>
#include <vector>

#include <Eigen/Core>

namespace cable_variation {

/// The convex hull of points as qhull finds it, cut into triangles.
struct HullFacets {
  std::vector<std::size_t> vertices;                    ///< points by index, ascending
  std::vector<std::array<std::uint32_t, 3>> triangles;  ///< of `vertices`, counter-clockwise from outside
  std::vector<std::array<std::uint32_t, 3>>
      neighbours;                        ///< triangle across the edge from corner i to the next
  std::vector<Eigen::Vector3d> normals;  ///< unit, outward; triangles of one facet share that of the facet
};

/// Throws std::invalid_argument: no points, or one that is not finite.
void checkHullPoints(const std::vector<Eigen::Vector3d>& points);

/// The surface is closed: each edge has two triangles. Throws InternalError with qhull's own words, for
/// points without a volume too.
HullFacets hullFacets(const std::vector<Eigen::Vector3d>& points);

}  // namespace cable_variation
