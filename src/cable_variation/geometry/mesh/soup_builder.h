#pragma once  // internal to geometry/

#include <map>
#include <vector>

#include <cable_variation/geometry/mesh/triangle_mesh.h>

namespace cable_variation {

/// Makes a mesh of what a file holds: equal vertices become one, polygons triangles.
class SoupBuilder {
 public:
  /// Of the mesh. Throws std::invalid_argument: not finite.
  std::uint32_t vertex(const Eigen::Vector3d& at);
  /// Of three or more corners, numbers of vertices; plane or nearly so, convex or not. Corners that repeat
  /// and what has no area are left out. Throws std::invalid_argument: too many corners.
  void polygon(const std::vector<std::uint32_t>& corners);
  TriangleMesh take() { return std::move(mesh_); }
  const TriangleMesh& mesh() const { return mesh_; }

 private:
  void triangle(std::uint32_t a, std::uint32_t b, std::uint32_t c);

  TriangleMesh mesh_;
  std::map<std::array<double, 3>, std::uint32_t> numbers_;
};

}  // namespace cable_variation
