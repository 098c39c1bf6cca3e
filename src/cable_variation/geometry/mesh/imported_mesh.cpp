#include <cable_variation/geometry/mesh/imported_mesh.h>

#include <cstring>
#include <stdexcept>

namespace cable_variation {
namespace {

constexpr std::size_t kHeader = 16, kPoint = 24, kTriangle = 12;  // bytes

template <typename Value>
void append(const Value* values, std::size_t count, std::string& bytes) {
  bytes.append(reinterpret_cast<const char*>(values), count * sizeof(Value));
}

}  // namespace

std::string bytesOf(const ImportedMesh& mesh) {
  static_assert(sizeof(mesh.points[0]) == kPoint && sizeof(mesh.triangles[0]) == kTriangle);
  const std::uint64_t counts[2] = {mesh.points.size(), mesh.triangles.size()};
  std::string bytes;
  bytes.reserve(kHeader + counts[0] * kPoint + counts[1] * kTriangle);
  append(counts, 2, bytes);
  append(mesh.points.data(), mesh.points.size(), bytes);
  append(mesh.triangles.data(), mesh.triangles.size(), bytes);
  return bytes;
}

std::size_t mostBytesOf(std::size_t triangles) { return kHeader + triangles * (3 * kPoint + kTriangle); }

ImportedMesh importedMesh(std::string_view bytes) {
  std::uint64_t counts[2] = {0, 0};
  if (bytes.size() < kHeader) throw std::invalid_argument("its importer handed over no mesh");
  std::memcpy(counts, bytes.data(), kHeader);
  bytes.remove_prefix(kHeader);
  const std::uint64_t most = bytes.size();  // no count is beyond it, and so no product is too large
  if (counts[0] > most || counts[1] > most || counts[0] * kPoint + counts[1] * kTriangle != bytes.size()) {
    throw std::invalid_argument("its importer handed over " + std::to_string(bytes.size()) +
                                " bytes; expected " + std::to_string(counts[0]) + " points and " +
                                std::to_string(counts[1]) + " triangles");
  }
  ImportedMesh mesh;
  mesh.points.resize(counts[0]);
  mesh.triangles.resize(counts[1]);
  std::memcpy(mesh.points.data(), bytes.data(), counts[0] * kPoint);
  std::memcpy(mesh.triangles.data(), bytes.data() + counts[0] * kPoint, counts[1] * kTriangle);
  for (const auto& triangle : mesh.triangles) {
    for (const std::uint32_t corner : triangle) {
      if (corner >= counts[0]) throw std::invalid_argument("its importer handed over a triangle of no point");
    }
  }
  return mesh;
}

}  // namespace cable_variation
