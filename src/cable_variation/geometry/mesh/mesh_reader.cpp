#include <cable_variation/geometry/mesh/mesh_reader.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <stdexcept>

#include <cable_variation/geometry/mesh/imported_mesh.h>
#include <cable_variation/geometry/mesh/obj_reader.h>
#include <cable_variation/geometry/mesh/ply_reader.h>
#include <cable_variation/geometry/mesh/soup_builder.h>
#include <cable_variation/geometry/mesh/stl_reader.h>
#include <cable_variation/util/import_program.h>
#include <cable_variation/util/regular_file.h>

namespace cable_variation {
namespace {

std::string lowerExtension(const std::string& path) {
  std::string extension = std::filesystem::path(path).extension().string();
  if (!extension.empty()) extension.erase(0, 1);
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return extension;
}

double area(const TriangleMesh& mesh) {
  double sum = 0.0;
  for (const auto& t : mesh.triangles) {
    const Eigen::Vector3d a = mesh.vertices[t[1]] - mesh.vertices[t[0]];
    const Eigen::Vector3d b = mesh.vertices[t[2]] - mesh.vertices[t[0]];
    const Eigen::Vector3d normal(a.y() * b.z() - a.z() * b.y(), a.z() * b.x() - a.x() * b.z(),
                                 a.x() * b.y() - a.y() * b.x());
    sum += 0.5 * normal.norm();
  }
  return sum;
}

// By a process of its own, for what reads it cannot be trusted.
TriangleMesh readCollada(const std::string& contents, const InputLimits& limits) {
  const ImportedMesh mesh = importedMesh(
      imported("collada_importer", {std::to_string(limits.xml_parts), std::to_string(limits.triangles)},
               contents, limits, mostBytesOf(limits.triangles),
               "it has more triangles; " + atMost(limits.triangles, "triangles")));
  SoupBuilder builder;
  std::vector<std::uint32_t> vertices;
  for (const auto& [x, y, z] : mesh.points) vertices.push_back(builder.vertex({x, y, z}));
  for (const auto& [a, b, c] : mesh.triangles) {
    builder.polygon({vertices[a], vertices[b], vertices[c]});
  }
  return builder.take();
}

TriangleMesh readUnscaled(const std::string& path, const InputLimits& limits) {
  const std::string extension = lowerExtension(path);
  const std::vector<std::string> allowed{"stl", "obj", "ply", "dae"};
  if (std::find(allowed.begin(), allowed.end(), extension) == allowed.end()) {
    throw std::invalid_argument("extension '" + extension +
                                "' is not a mesh's; expected stl, obj, ply or dae");
  }
  const std::string contents = readWhole(path, extension == "dae" ? limits.collada_bytes : limits.mesh_bytes);
  if (extension == "ply") return readPly(contents, limits.triangles);
  if (extension == "stl") return readStl(contents, limits.triangles);
  if (extension == "obj") return readObj(contents, limits.triangles);
  return readCollada(contents, limits);
}

}  // namespace

TriangleMesh scaled(const TriangleMesh& mesh, const Eigen::Vector3d& scale) {
  TriangleMesh result = mesh;
  for (Eigen::Vector3d& vertex : result.vertices) vertex = vertex.cwiseProduct(scale);
  if (scale.prod() < 0.0) {
    for (auto& triangle : result.triangles) std::swap(triangle[1], triangle[2]);
  }
  return result;
}

TriangleMesh readMesh(const std::string& path, const Eigen::Vector3d& scale, const InputLimits& limits) {
  try {
    TriangleMesh mesh = scaled(readUnscaled(path, limits), scale);
    for (const Eigen::Vector3d& vertex : mesh.vertices) {
      if (!vertex.allFinite()) throw std::invalid_argument("a vertex is not finite");
    }
    if (mesh.triangles.empty()) throw std::invalid_argument("it holds no triangle");
    if (!(area(mesh) > 0.0)) throw std::invalid_argument("none of its triangles has an area");
    return mesh;
  } catch (const std::exception& error) {
    throw std::invalid_argument("mesh '" + path + "': " + error.what());
  }
}

}  // namespace cable_variation
