#pragma once  // internal to geometry/

#include <array>
#include <cstdint>
#include <vector>

#include <Eigen/Core>

#include <cable_variation/geometry/mesh/triangle_mesh.h>

namespace cable_variation {

/// Part of a contour: vertices on edges of the grid's tetrahedra, each under the number of its edge, by which
/// parts are joined.
struct ContourPart {
  std::vector<std::uint64_t> edges;                     ///< of each vertex
  std::vector<Eigen::Vector3d> vertices;                ///< [m]
  std::vector<std::array<std::uint32_t, 3>> triangles;  ///< the side of positive values is outside
};

/// A cube of the grid, cut into kCubes³ smaller ones.
struct GridBlock {
  static constexpr int kCubes = 4, kPoints = kCubes + 1;
  static constexpr std::int64_t kLargest = std::int64_t{1} << 20;  ///< cubes along an axis

  std::array<std::int64_t, 3> first = {};                  ///< cube of the grid at the block's corner
  std::array<double, kPoints * kPoints * kPoints> values;  ///< at corners of cubes, x fastest

  static std::size_t at(int x, int y, int z) {
    const auto size = [](int value) { return static_cast<std::size_t>(value); };
    return (size(z) * kPoints + size(y)) * kPoints + size(x);
  }
};

/// Where the values, linear in each tetrahedron, are zero. Each cube is cut into the six tetrahedra about its
/// diagonal (Kuhn 1960); those of neighbouring cubes fit. So the contour of all blocks together is a manifold
/// provided that no value is zero: none may be. It is closed where the values at the border are positive.
/// @param origin,cell of the grid [m]
ContourPart contour(const GridBlock& block, const Eigen::Vector3d& origin, double cell);

/// The parts as one mesh.
TriangleMesh joined(const std::vector<ContourPart>& parts);

}  // namespace cable_variation
