#include <cable_variation/geometry/body/primitives.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

namespace cable_variation {
namespace {

constexpr double kSagitta = 5e-5;  // wanted gap between a chord and its arc [m]

void checkSize(const char* what, double value) {
  if (!(std::isfinite(value) && value > 0.0)) {
    throw std::invalid_argument(std::string(what) + " " + std::to_string(value) +
                                " m; expected more than 0 m");
  }
}

// Number of chords of a circle that keep the sagitta, within what stays cheap to draw.
std::uint32_t chords(double radius, std::uint32_t most) {
  const double half_angle = std::acos(std::max(0.0, 1.0 - kSagitta / radius));
  return std::clamp(static_cast<std::uint32_t>(std::ceil(std::min(M_PI / half_angle, 1e6))), 16u, most);
}

// The surface swept by a profile (radius, height) about z, from its lowest to its
// highest point; the first and the last lie on the axis.
TriangleMesh revolved(const std::vector<std::pair<double, double>>& profile, std::uint32_t around) {
  TriangleMesh mesh;
  const auto rings = static_cast<std::uint32_t>(profile.size()) - 2;
  mesh.vertices.emplace_back(0.0, 0.0, profile.front().second);
  for (std::uint32_t ring = 1; ring <= rings; ++ring) {
    for (std::uint32_t i = 0; i < around; ++i) {
      const double angle = 2.0 * M_PI * i / around;
      mesh.vertices.emplace_back(profile[ring].first * std::cos(angle), profile[ring].first * std::sin(angle),
                                 profile[ring].second);
    }
  }
  mesh.vertices.emplace_back(0.0, 0.0, profile.back().second);
  const auto top = static_cast<std::uint32_t>(mesh.vertices.size()) - 1;

  for (std::uint32_t i = 0; i < around; ++i) {
    const std::uint32_t next = (i + 1) % around;
    mesh.triangles.push_back({0, 1 + next, 1 + i});
    for (std::uint32_t ring = 0; ring + 1 < rings; ++ring) {
      const std::uint32_t low = 1 + ring * around;
      const std::uint32_t high = low + around;
      mesh.triangles.push_back({low + i, low + next, high + next});
      mesh.triangles.push_back({low + i, high + next, high + i});
    }
    const std::uint32_t last = 1 + (rings - 1) * around;
    mesh.triangles.push_back({last + i, last + next, top});
  }
  return mesh;
}

}  // namespace

TriangleMesh boxMesh(const Eigen::Vector3d& size) {
  for (int axis = 0; axis < 3; ++axis) checkSize("box size", size[axis]);
  TriangleMesh mesh;
  for (int corner = 0; corner < 8; ++corner) {
    mesh.vertices.emplace_back(((corner & 1) ? 0.5 : -0.5) * size.x(), ((corner & 2) ? 0.5 : -0.5) * size.y(),
                               ((corner & 4) ? 0.5 : -0.5) * size.z());
  }
  mesh.triangles = {{0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}, {0, 1, 5}, {0, 5, 4},
                    {2, 6, 7}, {2, 7, 3}, {0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}};
  return mesh;
}

TriangleMesh cylinderMesh(double radius, double length) {
  checkSize("cylinder radius", radius);
  checkSize("cylinder length", length);
  const double half = 0.5 * length;
  return revolved({{0.0, -half}, {radius, -half}, {radius, half}, {0.0, half}}, chords(radius, 128));
}

TriangleMesh sphereMesh(double radius) {
  checkSize("sphere radius", radius);
  const std::uint32_t around = chords(radius, 64);
  const std::uint32_t bands = around / 2;
  std::vector<std::pair<double, double>> profile;
  for (std::uint32_t i = 0; i <= bands; ++i) {
    const double polar = M_PI * i / bands;
    profile.emplace_back(radius * std::sin(polar), -radius * std::cos(polar));
  }
  return revolved(profile, around);
}

}  // namespace cable_variation
