#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

#include <cable_variation/geometry/mesh/box.h>
#include <cable_variation/geometry/mesh/facet_edges.h>
#include <cable_variation/geometry/mesh/triangle_mesh.h>

namespace cable_variation {

/// Which triangles of a mesh bound something, after it has been welded (mesh/welded_surface.h). A shell is
/// what hangs together by edges; it is closed if an even number of its facets meet at every edge.
///
/// A closed shell is a solid, whichever way its facets face. Only one that faces inwards throughout and lies
/// within another that faces outwards is no solid but a cavity of that one; facets that are turned about
/// among others do not matter.
///
/// All that is open is one shell more. Caps over its rims close it (mesh/oriented_facets.h), so that it is a
/// solid, or a cavity, like others. Whether there is truth in that, its winding number must tell: that of
/// the open facets alone, which is that of the closed shell less that of the caps.
struct Solids {
  static constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();

  struct Shell {
    Box box;
    std::uint32_t solid = 0;  ///< that it bounds
    bool cavity = false;
  };
  /// What bounds something, watertight. Empty: it is the mesh itself, triangle by triangle.
  TriangleMesh boundary;
  std::vector<std::uint32_t> source;  ///< of the boundary's facets: triangle of the mesh; of caps: one beside
  std::vector<Corners> corners;       ///< of the boundary's facets, numbers of positions
  std::vector<std::uint32_t> shell;   ///< of the boundary's facets; kNone: bounds nothing
  std::vector<std::uint32_t> shell_of_triangle;  ///< of the mesh's triangles; kNone likewise
  std::vector<Shell> shells;
  std::uint32_t count = 0;            ///< of solids
  std::optional<std::uint32_t> open;  ///< number of the shell that is not closed
  TriangleMesh caps;                  ///< over its rims, no vertices shared
  std::size_t rim_edges = 0;          ///< that have no neighbour
  double rim_length = 0.0;            ///< [m]

  explicit Solids(const TriangleMesh& mesh);
};

}  // namespace cable_variation
