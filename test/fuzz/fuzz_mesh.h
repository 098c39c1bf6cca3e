#pragma once

#include <cable_variation/geometry/mesh/triangle_mesh.h>

#include "fuzz_input.h"

namespace cable_variation {

/// A mesh reader: what it accepts is a mesh.
template <typename Read>
int fuzzMesh(const Read& read, const std::uint8_t* data, std::size_t size) {
  return acceptsOrRefuses([&] {
    const TriangleMesh mesh = read(textOf(data, size));
    for (const Eigen::Vector3d& vertex : mesh.vertices) {
      if (!vertex.allFinite()) throw std::logic_error("a vertex is not finite");
    }
    for (const auto& triangle : mesh.triangles) {
      for (const std::uint32_t corner : triangle) {
        if (corner >= mesh.vertices.size()) throw std::logic_error("a triangle of no vertex");
      }
    }
  });
}

}  // namespace cable_variation
