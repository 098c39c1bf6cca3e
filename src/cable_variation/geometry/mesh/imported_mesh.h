#pragma once  // internal to geometry/

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace cable_variation {

/// What the program collada_importer hands over: points, not merged, and triangles of them.
struct ImportedMesh {
  std::vector<std::array<double, 3>> points;
  std::vector<std::array<std::uint32_t, 3>> triangles;
};

/// As bytes, for a process on the same machine.
std::string bytesOf(const ImportedMesh& mesh);
/// How many bytes a mesh of so many triangles has at most.
std::size_t mostBytesOf(std::size_t triangles);

/// And back. Whatever the bytes are, the mesh is one: throws std::invalid_argument unless all of it is
/// there, nothing more, and its triangles are of its points.
ImportedMesh importedMesh(std::string_view bytes);

}  // namespace cable_variation
