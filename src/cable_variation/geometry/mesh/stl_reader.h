#pragma once  // internal to geometry/

#include <string_view>

#include <cable_variation/geometry/mesh/triangle_mesh.h>
#include <cable_variation/util/input_limits.h>

namespace cable_variation {

/// Reads an STL file, binary or text. Which of them it is its length tells: a binary one has room for as many
/// facets as it announces, 50 bytes each, whatever it begins with. Bytes after the last facet are passed
/// over, as are attributes and normals; a text may hold several solids. Throws std::invalid_argument with
/// what was expected where: cut off, words that are none of STL's, a coordinate that is no finite number.
TriangleMesh readStl(std::string_view file, std::size_t most_triangles = InputLimits().triangles);

}  // namespace cable_variation
