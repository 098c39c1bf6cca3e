#include <cable_variation/scene/merged_mesh.h>

#include <cstdint>

namespace cable_variation {

TriangleMesh mergedMesh(const Component& component) {
  TriangleMesh merged;
  for (const Visual& visual : component.visuals) {
    if (!visual.mesh) continue;
    const auto first = static_cast<std::uint32_t>(merged.vertices.size());
    for (const Eigen::Vector3d& vertex : visual.mesh->vertices)
      merged.vertices.push_back(visual.pose * vertex);
    for (const auto& corners : visual.mesh->triangles)
      merged.triangles.push_back({corners[0] + first, corners[1] + first, corners[2] + first});
  }
  return merged;
}

}  // namespace cable_variation
