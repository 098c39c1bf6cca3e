#pragma once  // internal to geometry/

#include <map>
#include <vector>

#include <cable_variation/geometry/mesh/triangle_mesh.h>
#include <cable_variation/util/input_limits.h>

namespace cable_variation {

/// Makes a mesh of what a file holds: equal vertices become one, polygons triangles.
class SoupBuilder {
 public:
  explicit SoupBuilder(std::size_t most_triangles = InputLimits().triangles)
      : most_triangles_(most_triangles) {}

  /// Of the mesh. Throws std::invalid_argument: not finite.
  std::uint32_t vertex(const Eigen::Vector3d& at);
  /// Of three or more corners, numbers of vertices; plane or nearly so, convex or not. Corners that repeat
  /// and what has no area are left out. Throws std::invalid_argument: too
  /// many triangles, or polygons whose division would take too long.
  void polygon(const std::vector<std::uint32_t>& corners);
  TriangleMesh take() { return std::move(mesh_); }
  const TriangleMesh& mesh() const { return mesh_; }

 private:
  void spend(std::size_t tests);
  void triangle(std::uint32_t a, std::uint32_t b, std::uint32_t c);

  TriangleMesh mesh_;
  std::size_t most_triangles_;
  std::size_t tests_ = 0;  // of corners within triangles
  std::map<std::array<double, 3>, std::uint32_t> numbers_;
};

}  // namespace cable_variation
