#pragma once  // internal to geometry/

#include <string_view>

#include <cable_variation/geometry/mesh/triangle_mesh.h>
#include <cable_variation/util/input_limits.h>

namespace cable_variation {

/// Reads the vertices and faces of a Wavefront OBJ file, all groups and objects together; corners may count
/// from the end (negative). All else (normals, textures, materials and their files, lines, curves) is passed
/// over: no other file is opened. The format has no end, so a file that was cut off between two lines is not
/// told from a whole one.
/// Throws std::invalid_argument with the line: a coordinate that is no finite number, a face of fewer than
/// three corners or of a vertex that is not there.
TriangleMesh readObj(std::string_view file, std::size_t most_triangles = InputLimits().triangles);

}  // namespace cable_variation
