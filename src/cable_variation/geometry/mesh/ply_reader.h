#pragma once  // internal to geometry/

#include <string_view>

#include <cable_variation/geometry/mesh/triangle_mesh.h>
#include <cable_variation/util/input_limits.h>

namespace cable_variation {

/// Reads a PLY file (G. Turk, The PLY polygon file format, 1994): text or binary of either byte order, faces
/// of any number of corners; properties and elements that are not needed are passed over. (A reader of our
/// own: assimp's reads beyond its buffers when a file is cut off, names vertices that are not there, or has
/// 0x0A as its first byte of data.)
/// Throws std::invalid_argument with what was expected where: the header is none, the file is cut off or goes
/// on behind its last element, a coordinate that is no finite number, a face of fewer than three corners or
/// of a vertex that is not there. A text's last line must end, or it could not be told from one cut off.
TriangleMesh readPly(std::string_view file, std::size_t most_triangles = InputLimits().triangles);

}  // namespace cable_variation
