#pragma once

#include <string>

#include <cable_variation/geometry/mesh/triangle_mesh.h>
#include <cable_variation/util/input_limits.h>

namespace cable_variation {

/// Reads a mesh file: STL, OBJ, PLY or COLLADA, told by its extension; no other
/// importer looks at it. The first three by readers of our own (mesh/), that name
/// what is wrong; COLLADA by assimp, in a process of its own with bounds on its memory and time, after
/// mesh/collada_check.h. No other file is opened.
/// All meshes of the file become one, in the file's frame with its nodes'
/// transforms applied and equal vertices merged, polygons divided into triangles. COLLADA's unit
/// is applied, its up axis is not: as RViz shows it.
/// @param scale factor per axis onto metres; a mirroring one turns the triangles about
/// Throws std::invalid_argument that names the file: another extension, not
/// readable, beyond the limits, no triangle with an area, a vertex that is not finite.
TriangleMesh readMesh(const std::string& path, const Eigen::Vector3d& scale = Eigen::Vector3d::Ones(),
                      const InputLimits& limits = {});

/// A copy scaled per axis; mirroring turns the triangles about.
TriangleMesh scaled(const TriangleMesh& mesh, const Eigen::Vector3d& scale);

}  // namespace cable_variation
