#pragma once

#include <cstdint>
#include <limits>
#include <vector>

#include <cable_variation/geometry/box.h>
#include <cable_variation/geometry/triangle_mesh.h>

namespace cable_variation {

/// Which triangles of a mesh bound something. A shell is what hangs together by edges; it is closed if an
/// even number of its triangles meet at every edge (a mesh with every triangle there twice, once for each
/// side, counts once). Corners at exactly the same position are the same corner.
///
/// A closed shell is a solid, whichever way its triangles face. Only one that faces inwards throughout and
/// lies within another that faces outwards is no solid but a cavity of that one.
struct Solids {
  static constexpr std::uint32_t kOpen = std::numeric_limits<std::uint32_t>::max();

  struct Shell {
    Box box;
    std::uint32_t solid = 0;  ///< that it bounds
    bool cavity = false;
  };
  std::vector<std::array<std::uint32_t, 3>> corners;  ///< of each triangle, numbers of positions
  std::vector<std::uint32_t> shell;                   ///< of each triangle; kOpen: bounds nothing
  std::vector<Shell> shells;                          ///< the closed ones
  std::uint32_t count = 0;                            ///< of solids

  explicit Solids(const TriangleMesh& mesh);
};

}  // namespace cable_variation
