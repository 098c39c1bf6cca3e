#pragma once  // internal to geometry/

#include <cstdint>
#include <vector>

#include <Eigen/Core>

#include <cable_variation/geometry/mesh/facet_edges.h>
#include <cable_variation/geometry/mesh/triangle_mesh.h>

namespace cable_variation {

/// The surface of a mesh as its facets are meant to hang together. Facets of closed groups (facet_edges.h,
/// vertices at exactly the same position being one) are left as they are. What is open is mended as exporters
/// need it:
/// - vertices on open edges that are within kRounding of each other become one;
/// - facets whose height is below that are left out, and facets that are there several times count once, or
///   not at all, whichever leaves fewer edges open;
/// - an edge on which vertices of the other side lie is divided at them (T-junctions);
/// - what is still open has cracks of up to kCrack closed in the same two ways, wherever that closes all of a
///   group. A crack is at most a quarter as wide as the edges beside it are long: nothing collapses.
/// So no vertex moves by more than the gap that was closed.
struct WeldedSurface {
  static constexpr double kRounding = 1e-6;  ///< of the mesh's diagonal
  static constexpr double kFloat = 2.5e-7;  ///< of the largest coordinate, beside it: float's rounding, twice
  static constexpr double kCrack = 1e-4;    ///< of the mesh's diagonal

  std::vector<Eigen::Vector3d> vertices;
  std::vector<Corners> facets;
  std::vector<std::uint32_t> source;  ///< of each facet: the mesh's triangle that it is, or is a piece of
  bool mended = false;                ///< else facets are the mesh's triangles, one by one

  explicit WeldedSurface(const TriangleMesh& mesh);
};

}  // namespace cable_variation
