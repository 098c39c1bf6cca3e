#pragma once

#include <cable_variation/geometry/mesh/triangle_mesh.h>

namespace cable_variation {

/// Closed meshes of URDF's primitives, centred at the origin, vertices on the
/// surface. Throw std::invalid_argument naming the size unless it is positive and finite.

/// @param size along x, y and z [m]
TriangleMesh boxMesh(const Eigen::Vector3d& size);
/// Axis along z. @param radius,length [m]
TriangleMesh cylinderMesh(double radius, double length);
/// @param radius [m]
TriangleMesh sphereMesh(double radius);

}  // namespace cable_variation
