// Tubes and meshes as triangles: closed, the right way round, with normals that fit.
#include <rviz_plugins/displays/mesh_surface.h>
#include <rviz_plugins/displays/surface.h>

#include <cmath>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

namespace cable_variation_rviz {
namespace {

using Eigen::Vector3f;

/// The volume inside [m³], positive if triangles are counter-clockwise seen from outside.
double volumeOf(const Surface& surface) {
  double volume = 0.0;
  for (std::size_t i = 0; i < surface.triangles.size(); i += 3) {
    const auto corner = [&](std::size_t k) {
      return surface.positions[surface.triangles[i + k]].cast<double>().eval();
    };
    volume += corner(0).dot(corner(1).cross(corner(2))) / 6.0;
  }
  return volume;
}

/// Along an arc of radius 0.1 m and 90°, with the same station twice in it.
std::vector<Vector3f> arc() {
  std::vector<Vector3f> line;
  for (int i = 0; i <= 60; ++i) {
    const float angle = static_cast<float>(M_PI / 2.0) * static_cast<float>(i) / 60.0F;
    line.emplace_back(0.1F * std::sin(angle), 0.1F - 0.1F * std::cos(angle), 0.02F);
    if (i == 30) line.push_back(line.back());
  }
  return line;
}

TEST(TubeSurfaces, HoldTheVolumeOfTheTube) {
  const std::vector<Vector3f> line = arc();
  const TubeSurface tube = tubeSurface(line, std::vector<float>(line.size(), 0.01F), 48);
  const double expected = M_PI * 0.01 * 0.01 * 0.1 * M_PI / 2.0;  // Pappus
  EXPECT_NEAR(volumeOf(tube), expected, 0.01 * expected);
}

TEST(TubeSurfaces, HaveUnitNormalsAcrossTheLine) {
  const std::vector<Vector3f> line = arc();
  const TubeSurface tube = tubeSurface(line, std::vector<float>(line.size(), 0.01F), 12);
  ASSERT_EQ(tube.positions.size(), tube.normals.size());
  ASSERT_EQ(tube.positions.size(), tube.stations.size());
  for (std::size_t i = 0; i < tube.positions.size(); ++i) {
    EXPECT_NEAR(tube.normals[i].norm(), 1.0F, 1e-5F);
    EXPECT_NEAR((tube.positions[i] - line[tube.stations[i]]).norm(), 0.01F, 1e-6F);
    EXPECT_GE(tube.normals[i].dot(tube.positions[i] - line[tube.stations[i]]), -1e-6F);
  }
}

TEST(TubeSurfaces, OfNoLineAreEmpty) {
  EXPECT_TRUE(tubeSurface({}, {}, 12).triangles.empty());
  EXPECT_TRUE(tubeSurface({Vector3f::Zero()}, {0.1F}, 12).triangles.empty());
}

TEST(TubeSurfaces, OfOnePlaceAreFinite) {
  const TubeSurface tube = tubeSurface({Vector3f::Ones(), Vector3f::Ones()}, {0.1F, 0.1F}, 8);
  for (const Vector3f& normal : tube.normals) EXPECT_TRUE(normal.allFinite());
}

TEST(MeshSurfaces, AreSharpOverACubesEdges) {
  const std::vector<Vector3f> corners = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0},
                                         {0, 0, 1}, {1, 0, 1}, {0, 1, 1}, {1, 1, 1}};
  const std::vector<std::uint32_t> triangles = {0, 2, 1, 1, 2, 3, 4, 5, 6, 5, 7, 6, 0, 1, 4, 1, 5, 4,
                                                2, 6, 3, 3, 6, 7, 0, 4, 2, 2, 4, 6, 1, 3, 5, 3, 7, 5};
  const Surface cube = meshSurface(corners, triangles, 0.6F);
  EXPECT_EQ(cube.positions.size(), 24U);  // three at each corner
  EXPECT_EQ(cube.triangles.size(), triangles.size());
  EXPECT_NEAR(volumeOf(cube), 1.0, 1e-6);
  for (const Vector3f& normal : cube.normals) {
    EXPECT_NEAR(normal.cwiseAbs().maxCoeff(), 1.0F, 1e-5F);
  }
}

TEST(MeshSurfaces, AreSmoothOverFlatEdgesAndLeaveOutFlatTriangles) {
  const float slope = 0.2F;
  const std::vector<Vector3f> roof = {{-1, 0, -slope}, {-1, 1, -slope}, {0, 0, 0},
                                      {0, 1, 0},       {1, 0, -slope},  {1, 1, -slope}};
  const Surface surface = meshSurface(roof, {0, 2, 1, 1, 2, 3, 2, 4, 3, 3, 4, 5, 0, 2, 2}, 0.6F);
  EXPECT_EQ(surface.triangles.size(), 12U);
  EXPECT_EQ(surface.positions.size(), 6U);
  for (std::size_t i = 0; i < surface.positions.size(); ++i) {
    // on the ridge between the slopes' own, 0.98; one side has two triangles there, so not quite in the
    // middle
    EXPECT_GT(surface.normals[i].z(), surface.positions[i].x() == 0.0F ? 0.99F : 0.97F);
  }
}

}  // namespace
}  // namespace cable_variation_rviz
