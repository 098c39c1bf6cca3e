#include <cable_variation/report/picture/tube_mesh.h>

#include <algorithm>
#include <cmath>

namespace cable_variation {

using Eigen::Vector3d;

namespace {

constexpr std::uint32_t kSides = 20;
constexpr std::size_t kMostRings = 2000;

void addRing(TubeMesh& tube, const Pose& section, double radius) {
  for (std::uint32_t k = 0; k < kSides; ++k) {
    const double angle = 2.0 * M_PI * k / kSides;
    const Vector3d normal = section.orientation * Vector3d(0.0, std::cos(angle), std::sin(angle));
    tube.mesh.vertices.push_back(section.position + radius * normal);
    tube.normals.push_back(normal);
  }
}

/// A flat end, looking along `side` times the section's normal.
void addLid(TubeMesh& tube, const Pose& section, double radius, double side) {
  const auto first = static_cast<std::uint32_t>(tube.mesh.vertices.size());
  addRing(tube, section, radius);
  const Vector3d outwards = side * (section.orientation * Vector3d::UnitX());
  std::fill(tube.normals.end() - kSides, tube.normals.end(), outwards);
  for (std::uint32_t k = 1; k + 1 < kSides; ++k) {
    const std::uint32_t b = first + k, c = first + k + 1;
    tube.mesh.triangles.push_back(side > 0.0 ? std::array<std::uint32_t, 3>{first, b, c}
                                             : std::array<std::uint32_t, 3>{first, c, b});
  }
}

}  // namespace

TubeMesh tubeMesh(const Cable& cable, const CableShape& shape, double step) {
  const double wanted = std::ceil(cable.length / step) + 1.0;
  const auto count = static_cast<std::size_t>(std::clamp(wanted, 2.0, static_cast<double>(kMostRings)));
  const std::vector<Pose> sections = shape.sample(count);
  const auto radiusAt = [&](std::size_t i) {
    return sectionAt(cable, cable.length * static_cast<double>(i) / static_cast<double>(count - 1)).radius;
  };
  TubeMesh tube;
  for (std::size_t i = 0; i < count; ++i) {
    addRing(tube, sections[i], radiusAt(i));
    if (i == 0) continue;
    const auto ring = static_cast<std::uint32_t>(i) * kSides, before = ring - kSides;
    for (std::uint32_t k = 0; k < kSides; ++k) {
      const std::uint32_t next = (k + 1) % kSides;
      tube.mesh.triangles.push_back({before + k, before + next, ring + next});
      tube.mesh.triangles.push_back({before + k, ring + next, ring + k});
    }
  }
  addLid(tube, sections.front(), radiusAt(0), -1.0);
  addLid(tube, sections.back(), radiusAt(count - 1), 1.0);
  return tube;
}

}  // namespace cable_variation
