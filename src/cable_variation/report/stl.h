#pragma once

#include <string>

#include <cable_variation/geometry/mesh/triangle_mesh.h>

namespace cable_variation {

/// A mesh as the bytes of a binary STL file, in metres. Coordinates are rounded to 24 bits, as the format has
/// it: 3e-8 m at half a metre from the origin.
/// @param title the first 80 characters are kept; must not begin with "solid", by which text files are told
/// Throws std::invalid_argument: such a title, a coordinate that is not finite in 24 bits, 2^32 triangles.
std::string binaryStl(const TriangleMesh& mesh, const std::string& title);

/// By how much its coordinates may be rounded there [m]: 3e-8 m at half a metre from the origin, 0.03 m at a
/// thousand kilometres.
double stlRounding(const TriangleMesh& mesh);

}  // namespace cable_variation
