#include <rviz_plugins/displays/mesh_surface.h>

#include <cmath>

#include <Eigen/Geometry>

namespace cable_variation_rviz {

using Eigen::Vector3f;

namespace {

constexpr float kSameNormal = 0.9999F;  // cosine of the angle that is not seen

/// A corner of a triangle.
struct Corner {
  std::size_t at;        // in the list of triangles
  Vector3f area_normal;  // of the triangle, twice its area long
};

/// The mean of the normals around a vertex that are within the crease of one of them.
Vector3f smoothNormal(const std::vector<Corner>& around, const Corner& of, float least_cosine) {
  const Vector3f own = of.area_normal.normalized();
  Vector3f sum = Vector3f::Zero();
  for (const Corner& corner : around) {
    if (corner.area_normal.normalized().dot(own) >= least_cosine) sum += corner.area_normal;
  }
  return sum.normalized();
}

}  // namespace

Surface meshSurface(const std::vector<Vector3f>& positions, const std::vector<std::uint32_t>& triangles,
                    float crease) {
  std::vector<std::vector<Corner>> around(positions.size());
  Surface surface;
  for (std::size_t i = 0; i + 2 < triangles.size(); i += 3) {
    const Vector3f& first = positions[triangles[i]];
    const Vector3f normal = (positions[triangles[i + 1]] - first).cross(positions[triangles[i + 2]] - first);
    if (!(normal.norm() > 0.0F)) continue;
    for (std::size_t k = 0; k < 3; ++k) {
      around[triangles[i + k]].push_back({surface.triangles.size(), normal});
      surface.triangles.push_back(0);
    }
  }
  const float least_cosine = std::cos(crease);
  for (std::size_t vertex = 0; vertex < positions.size(); ++vertex) {
    const std::size_t first = surface.positions.size();  // of this vertex's, which differ by their normals
    for (const Corner& corner : around[vertex]) {
      const Vector3f normal = smoothNormal(around[vertex], corner, least_cosine);
      std::size_t found = first;
      while (found < surface.normals.size() && surface.normals[found].dot(normal) < kSameNormal) ++found;
      if (found == surface.normals.size()) {
        surface.positions.push_back(positions[vertex]);
        surface.normals.push_back(normal);
      }
      surface.triangles[corner.at] = static_cast<std::uint32_t>(found);
    }
  }
  return surface;
}

}  // namespace cable_variation_rviz
