#pragma once  // internal to report/

#include <cable_variation/equilibrium/equilibrium.h>
#include <cable_variation/geometry/mesh/triangle_mesh.h>

namespace cable_variation {

/// A cable's surface: rings about its centreline [m, world], closed at its ends.
struct TubeMesh {
  TriangleMesh mesh;
  std::vector<Eigen::Vector3d> normals;  ///< outwards, one per vertex
};

/// Of a round cable with the radius of each section, whatever its section is made of.
/// @param step largest distance of rings along the cable [m]
TubeMesh tubeMesh(const Cable& cable, const CableShape& shape, double step);

}  // namespace cable_variation
