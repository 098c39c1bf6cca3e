#pragma once

#include <map>
#include <set>
#include <string>
#include <utility>

#include <Eigen/Geometry>

#include <cable_variation/geometry/mesh/triangle_mesh.h>

namespace cable_variation {

inline double enclosedVolume(const TriangleMesh& mesh) {
  double sum = 0.0;
  for (const auto& t : mesh.triangles) {
    sum += mesh.vertices[t[0]].dot(mesh.vertices[t[1]].cross(mesh.vertices[t[2]])) / 6.0;
  }
  return sum;
}

/// What keeps a mesh from being a closed, oriented manifold; empty: nothing.
inline std::string surfaceFault(const TriangleMesh& mesh) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> edges;
  std::map<std::uint32_t, std::map<std::uint32_t, std::uint32_t>> around;  // per vertex: the edges opposite
  for (const auto& t : mesh.triangles) {
    for (std::size_t i = 0; i < 3; ++i) {
      if (t[i] >= mesh.vertices.size()) return "a triangle names no vertex";
      if (t[i] == t[(i + 1) % 3]) return "a triangle names a vertex twice";
      ++edges[{t[i], t[(i + 1) % 3]}];
      around[t[i]][t[(i + 1) % 3]] = t[(i + 2) % 3];
    }
  }
  if (around.size() != mesh.vertices.size()) return "a vertex without triangles";
  for (const auto& [edge, count] : edges) {
    const auto reverse = edges.find({edge.second, edge.first});
    if (count != 1 || reverse == edges.end()) {
      return "edge " + std::to_string(edge.first) + " " + std::to_string(edge.second);
    }
  }
  for (const auto& [vertex, next] : around) {
    std::size_t turn = 0;
    std::uint32_t at = next.begin()->first;
    do {
      at = next.at(at);
      ++turn;
    } while (at != next.begin()->first);
    if (turn != next.size())
      return "the triangles of vertex " + std::to_string(vertex) + " are no single fan";
  }
  return "";
}

/// V - E + F of a closed mesh: 2 per component, less 2 per handle.
inline int eulerCharacteristic(const TriangleMesh& mesh) {
  return static_cast<int>(mesh.vertices.size()) - static_cast<int>(mesh.triangles.size()) / 2;
}

}  // namespace cable_variation
