#include <cable_variation/geometry/body/primitives.h>

#include <cmath>
#include <limits>
#include <map>
#include <stdexcept>
#include <utility>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

namespace cable_variation {
namespace {

double volume(const TriangleMesh& mesh) {
  double sum = 0.0;
  for (const auto& t : mesh.triangles) {
    sum += mesh.vertices[t[0]].dot(mesh.vertices[t[1]].cross(mesh.vertices[t[2]])) / 6.0;
  }
  return sum;
}

// Every directed edge once, and its reverse once.
bool isClosed(const TriangleMesh& mesh) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> edges;
  for (const auto& t : mesh.triangles) {
    for (std::size_t i = 0; i < 3; ++i) ++edges[{t[i], t[(i + 1) % 3]}];
  }
  for (const auto& [edge, count] : edges) {
    const auto reverse = edges.find({edge.second, edge.first});
    if (count != 1 || reverse == edges.end() || reverse->second != 1) return false;
  }
  return true;
}

TEST(Primitives, box) {
  const TriangleMesh mesh = boxMesh({0.2, 0.1, 0.05});
  EXPECT_TRUE(isClosed(mesh));
  EXPECT_NEAR(volume(mesh), 0.001, 1e-15);
}

TEST(Primitives, cylinder) {
  const TriangleMesh mesh = cylinderMesh(0.02, 0.3);
  EXPECT_TRUE(isClosed(mesh));
  EXPECT_NEAR(volume(mesh) / (M_PI * 0.02 * 0.02 * 0.3), 1.0, 0.01);
  for (const Eigen::Vector3d& vertex : mesh.vertices) {
    EXPECT_NEAR(std::abs(vertex.z()), 0.15, 1e-15);
    const double radius = vertex.head<2>().norm();
    EXPECT_TRUE(radius == 0.0 || std::abs(radius - 0.02) < 1e-15) << radius;
  }
}

TEST(Primitives, sphere) {
  const TriangleMesh mesh = sphereMesh(0.05);
  EXPECT_TRUE(isClosed(mesh));
  EXPECT_NEAR(volume(mesh) / (4.0 / 3.0 * M_PI * std::pow(0.05, 3)), 1.0, 0.01);
  for (const Eigen::Vector3d& vertex : mesh.vertices) EXPECT_NEAR(vertex.norm(), 0.05, 1e-15);
}

TEST(Primitives, fromTinyToHugeStayBoundedInTriangles) {
  for (const double radius : {1e-6, 1e-3, 1.0, 1e3}) {
    const TriangleMesh mesh = sphereMesh(radius);
    EXPECT_GE(mesh.triangles.size(), 100U) << radius;
    EXPECT_LE(mesh.triangles.size(), 5000U) << radius;
  }
}

TEST(Primitives, refuseSizesThatAreNone) {
  EXPECT_THROW(boxMesh({0.1, 0.0, 0.1}), std::invalid_argument);
  EXPECT_THROW(cylinderMesh(-0.1, 1.0), std::invalid_argument);
  EXPECT_THROW(cylinderMesh(0.1, std::numeric_limits<double>::quiet_NaN()), std::invalid_argument);
  EXPECT_THROW(sphereMesh(std::numeric_limits<double>::infinity()), std::invalid_argument);
}

}  // namespace
}  // namespace cable_variation
