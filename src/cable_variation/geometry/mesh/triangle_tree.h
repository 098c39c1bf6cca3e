#pragma once

#include <cstdint>
#include <vector>

#include <cable_variation/geometry/mesh/box.h>
#include <cable_variation/geometry/mesh/surface_triangle.h>
#include <cable_variation/geometry/mesh/triangle_mesh.h>

namespace cable_variation {

/// A mesh's triangles below a hierarchy of axis-aligned boxes. Node 0 is the root. FCL divides; the nodes are
/// copied into one flat array, two to a step, with leaves of a few triangles, which is what makes walking
/// fast.
struct TriangleTree {
  struct Node {
    Box box;
    std::uint32_t first = 0;  ///< leaf: triangle; else the left child, the right one follows it
    std::uint32_t count = 0;  ///< triangles of a leaf; 0: no leaf
  };
  std::vector<Node> nodes;
  std::vector<SurfaceTriangle> triangles;  ///< in the leaves' order
  std::vector<std::uint32_t> number;       ///< of each of them in the mesh

  /// Throws std::invalid_argument for a mesh without triangles, one whose triangles name
  /// no vertex, or whose vertices are not finite.
  explicit TriangleTree(const TriangleMesh& mesh);
};

}  // namespace cable_variation
