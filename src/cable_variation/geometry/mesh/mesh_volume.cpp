#include <cable_variation/geometry/mesh/mesh_volume.h>

#include <Eigen/Geometry>

namespace cable_variation {

double volumeWithin(const TriangleMesh& mesh) {
  if (mesh.triangles.empty()) return 0.0;
  // seen from a vertex, lest a mesh far from the origin lose digits
  const Eigen::Vector3d& origin = mesh.vertices[mesh.triangles.front()[0]];
  double sixfold = 0.0;
  for (const auto& [a, b, c] : mesh.triangles) {
    sixfold += (mesh.vertices[a] - origin).dot((mesh.vertices[b] - origin).cross(mesh.vertices[c] - origin));
  }
  return sixfold / 6.0;
}

}  // namespace cable_variation
