#pragma once  // internal to geometry/

#include <vector>

#include <Eigen/Core>

#include <cable_variation/geometry/mesh/facet_edges.h>

namespace cable_variation {

/// Facets turned about so that neighbours face the same way, wherever two meet at an edge. Each patch that
/// hangs together by such edges faces as most of its area did before.
struct OrientedFacets {
  std::vector<Corners> facets;
  std::vector<std::uint8_t> facing;  ///< of each group: two facets at every edge, which now face the same way

  OrientedFacets(const std::vector<Eigen::Vector3d>& vertices, const std::vector<Corners>& facets,
                 const FacetGroups& groups);
};

/// Triangles that close the rims of oriented facets: for every edge that these run along more often one way
/// than the other, one from it to the middle of its rim. Together the facets and these are closed, so their
/// winding number is whole everywhere, and that of the facets is short of it by that of these alone.
struct RimCaps {
  std::vector<Eigen::Vector3d> middles;  ///< corners beyond the vertices given: their number is this index
                                         ///< plus that of the vertices
  std::vector<Corners> facets;
  std::vector<std::uint32_t> beside;  ///< of each: a facet that its edge is of
  double rim_length = 0.0;            ///< [m]

  /// @param left_out facets that do not count
  RimCaps(const std::vector<Eigen::Vector3d>& vertices, const std::vector<Corners>& facets,
          const std::vector<std::uint8_t>& left_out);
};

}  // namespace cable_variation
