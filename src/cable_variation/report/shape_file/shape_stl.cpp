#include <cable_variation/report/picture/tube_mesh.h>
#include <cable_variation/report/shape_file/cable_points.h>
#include <cable_variation/report/shape_file/shape_file.h>
#include <cable_variation/report/stl.h>

namespace cable_variation {

std::string shapeStl(const SolvedScene& solved, const std::vector<std::size_t>& cables, double step) {
  TriangleMesh all;
  for (const std::size_t cable : cables) {
    checkStep(solved.harness.cables[cable], step);
    const TubeMesh tube = tubeMesh(solved.harness.cables[cable], solved.equilibrium.shapes[cable], step);
    const auto first = static_cast<std::uint32_t>(all.vertices.size());
    all.vertices.insert(all.vertices.end(), tube.mesh.vertices.begin(), tube.mesh.vertices.end());
    for (const auto& [a, b, c] : tube.mesh.triangles)
      all.triangles.push_back({first + a, first + b, first + c});
  }
  return binaryStl(all, "cables of cable_variation [m]");
}

}  // namespace cable_variation
