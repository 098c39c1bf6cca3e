#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include <Eigen/Core>

namespace cable_variation {

/// Triangles over shared vertices [m].
struct TriangleMesh {
  std::vector<Eigen::Vector3d> vertices;
  std::vector<std::array<std::uint32_t, 3>> triangles;  ///< counter-clockwise seen from outside
};

}  // namespace cable_variation
