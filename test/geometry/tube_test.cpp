// Swept tubes: watertight, facing outwards, of the right volume.
#include <cable_variation/geometry/tube_distance/tube.h>

#include <cmath>
#include <map>
#include <stdexcept>

#include <gtest/gtest.h>

namespace cable_variation {
namespace {

double volume(const TriangleMesh& mesh) {
  double six_volumes = 0.0;
  for (const auto& [a, b, c] : mesh.triangles) {
    six_volumes += mesh.vertices[a].dot(mesh.vertices[b].cross(mesh.vertices[c]));
  }
  return six_volumes / 6.0;
}

/// Every edge is used once in each direction.
bool watertight(const TriangleMesh& mesh) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> edges;
  for (const auto& triangle : mesh.triangles) {
    for (std::size_t i = 0; i < 3; ++i) ++edges[{triangle[i], triangle[(i + 1) % 3]}];
  }
  for (const auto& [edge, count] : edges) {
    const auto back = edges.find({edge.second, edge.first});
    if (count != 1 || back == edges.end() || back->second != 1) return false;
  }
  return true;
}

std::vector<Pose> straight(int count, double length) {
  std::vector<Pose> path(static_cast<std::size_t>(count));
  for (int i = 0; i < count; ++i) path[static_cast<std::size_t>(i)].position.x() = length * i / (count - 1);
  return path;
}

TEST(Tube, AStraightOneIsAPrism) {
  const TriangleMesh mesh = tubeMesh(straight(5, 0.3), 0.01, 6);
  EXPECT_TRUE(watertight(mesh));
  // Hexagon of circumradius r: 3/2 √3 r².
  EXPECT_NEAR(volume(mesh), 0.3 * 1.5 * std::sqrt(3.0) * 1e-4, 1e-15);
}

TEST(Tube, AClosedOneIsATorus) {
  constexpr int kSteps = 200;
  std::vector<Pose> path;
  for (int i = 0; i < kSteps; ++i) {
    const Eigen::Quaterniond turn(Eigen::AngleAxisd(2.0 * M_PI * i / kSteps, Eigen::Vector3d::UnitZ()));
    path.push_back({turn * Eigen::Vector3d(0.0, -0.1, 0.0), turn});
  }
  const TriangleMesh mesh = tubeMesh(path, 0.02, 100, true);
  EXPECT_TRUE(watertight(mesh));
  const double torus = 2.0 * M_PI * M_PI * 0.1 * 0.02 * 0.02;
  EXPECT_NEAR(volume(mesh), torus, 2e-3 * torus);
}

TEST(Tube, RefusesWhatIsNoTube) {
  EXPECT_THROW(tubeMesh(straight(2, 1.0), 0.0, 6), std::invalid_argument);
  EXPECT_THROW(tubeMesh(straight(2, 1.0), std::nan(""), 6), std::invalid_argument);
  EXPECT_THROW(tubeMesh(straight(2, 1.0), 0.1, 2), std::invalid_argument);
  EXPECT_THROW(tubeMesh({Pose()}, 0.1, 6), std::invalid_argument);
  EXPECT_THROW(tubeMesh(straight(2, 1.0), 0.1, 6, true), std::invalid_argument);
}

}  // namespace
}  // namespace cable_variation
