#include <cable_variation/report/stl.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <stdexcept>

#include <Eigen/Geometry>

namespace cable_variation {
namespace {

constexpr std::size_t kTitle = 80, kTriangle = 50;  // bytes

// Little-endian, on every machine.
void append(std::string& bytes, std::uint32_t value) {
  for (int shift = 0; shift < 32; shift += 8) bytes.push_back(static_cast<char>(value >> shift & 0xff));
}

void append(std::string& bytes, const Eigen::Vector3d& vector) {
  for (const double coordinate : {vector.x(), vector.y(), vector.z()}) {
    const auto rounded = static_cast<float>(coordinate);
    std::uint32_t bits;
    static_assert(sizeof bits == sizeof rounded, "IEEE 754 single precision");
    std::memcpy(&bits, &rounded, sizeof bits);
    append(bytes, bits);
  }
}

}  // namespace

std::string binaryStl(const TriangleMesh& mesh, const std::string& title) {
  if (title.compare(0, 5, "solid") == 0) {
    throw std::invalid_argument("STL title '" + title + "' begins with 'solid', as text files do");
  }
  if (mesh.triangles.size() > std::numeric_limits<std::uint32_t>::max()) {
    throw std::invalid_argument("STL: " + std::to_string(mesh.triangles.size()) +
                                " triangles; expected fewer than 2^32");
  }
  for (const Eigen::Vector3d& vertex : mesh.vertices) {
    if (!(vertex.cwiseAbs().maxCoeff() <= static_cast<double>(std::numeric_limits<float>::max()))) {
      throw std::invalid_argument("STL: a vertex is not finite");
    }
  }
  std::string bytes = title;
  bytes.resize(kTitle, ' ');
  bytes.reserve(kTitle + 4 + kTriangle * mesh.triangles.size());
  append(bytes, static_cast<std::uint32_t>(mesh.triangles.size()));
  for (const auto& [a, b, c] : mesh.triangles) {
    const Eigen::Vector3d normal =
        (mesh.vertices[b] - mesh.vertices[a]).cross(mesh.vertices[c] - mesh.vertices[a]);
    const double length = normal.norm();
    append(bytes, length > 0.0 ? Eigen::Vector3d(normal / length) : Eigen::Vector3d(Eigen::Vector3d::Zero()));
    for (const std::uint32_t corner : {a, b, c}) append(bytes, mesh.vertices[corner]);
    bytes.append(2, '\0');  // no attributes
  }
  return bytes;
}

double stlRounding(const TriangleMesh& mesh) {
  double largest = 0.0;
  for (const Eigen::Vector3d& vertex : mesh.vertices)
    largest = std::max(largest, vertex.cwiseAbs().maxCoeff());
  const auto rounded = static_cast<float>(largest);
  return 0.5 * static_cast<double>(std::nextafter(rounded, std::numeric_limits<float>::infinity()) - rounded);
}

}  // namespace cable_variation
