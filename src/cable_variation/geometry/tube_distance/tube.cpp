#include <cable_variation/geometry/tube_distance/tube.h>

#include <cmath>
#include <stdexcept>
#include <string>

namespace cable_variation {

namespace {

void checkArguments(const std::vector<Pose>& path, double radius, std::size_t sides, bool closed) {
  if (!(radius > 0.0) || !std::isfinite(radius)) {
    throw std::invalid_argument("tube: radius " + std::to_string(radius) + " m, expected above 0");
  }
  if (sides < 3)
    throw std::invalid_argument("tube: " + std::to_string(sides) + " sides, expected at least 3");
  const std::size_t least = closed ? 3 : 2;
  if (path.size() < least) {
    throw std::invalid_argument("tube: " + std::to_string(path.size()) + " poses, expected at least " +
                                std::to_string(least));
  }
}

}  // namespace

TriangleMesh tubeMesh(const std::vector<Pose>& path, double radius, std::size_t sides, bool closed) {
  checkArguments(path, radius, sides, closed);
  TriangleMesh mesh;
  mesh.vertices.reserve(path.size() * sides + 2);
  for (const Pose& pose : path) {
    for (std::size_t k = 0; k < sides; ++k) {
      const double angle = 2.0 * M_PI * static_cast<double>(k) / static_cast<double>(sides);
      mesh.vertices.push_back(pose *
                              Eigen::Vector3d(0.0, radius * std::cos(angle), radius * std::sin(angle)));
    }
  }

  const auto vertex = [&](std::size_t ring, std::size_t k) {
    return static_cast<std::uint32_t>((ring % path.size()) * sides + k % sides);
  };
  const std::size_t spans = closed ? path.size() : path.size() - 1;
  for (std::size_t i = 0; i < spans; ++i) {
    for (std::size_t k = 0; k < sides; ++k) {
      mesh.triangles.push_back({vertex(i, k), vertex(i + 1, k + 1), vertex(i + 1, k)});
      mesh.triangles.push_back({vertex(i, k), vertex(i, k + 1), vertex(i + 1, k + 1)});
    }
  }

  if (!closed) {
    const auto start = static_cast<std::uint32_t>(mesh.vertices.size());
    mesh.vertices.push_back(path.front().position);
    mesh.vertices.push_back(path.back().position);
    for (std::size_t k = 0; k < sides; ++k) {
      mesh.triangles.push_back({start, vertex(0, k + 1), vertex(0, k)});
      mesh.triangles.push_back({start + 1, vertex(path.size() - 1, k), vertex(path.size() - 1, k + 1)});
    }
  }
  return mesh;
}

}  // namespace cable_variation
