#pragma once  // internal to geometry/

#include <cstddef>

#include <cable_variation/geometry/mesh/triangle_mesh.h>

namespace cable_variation {

/// A closed manifold mesh of which only what can be seen from outside is left.
struct FilledSurface {
  TriangleMesh mesh;
  std::size_t components = 0;    ///< left
  std::size_t filled_voids = 0;  ///< components that bounded a void
};

/// @param mesh closed and oriented; its components neither meet nor cross
FilledSurface filledSurface(const TriangleMesh& mesh);

}  // namespace cable_variation
