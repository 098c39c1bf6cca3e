#include <cable_variation/geometry/body/voxel_set.h>

#include <cmath>
#include <limits>
#include <random>
#include <stdexcept>

#include <gtest/gtest.h>

namespace cable_variation {
namespace {

constexpr double kOnBorder = 1e-9;  // middles this close to a border may be on either side [m]

Eigen::Vector3d randomPoint(std::mt19937_64& random) {
  std::uniform_real_distribution<double> coordinate(-1.0, 1.0);
  return {coordinate(random), coordinate(random), coordinate(random)};
}

Box cube(double half) {
  Box box;
  box.low.setConstant(-half);
  box.high.setConstant(half);
  return box;
}

double segmentDistance(const Eigen::Vector3d& x, const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
  const double squared = (b - a).squaredNorm();
  const double t = squared > 0.0 ? std::clamp((x - a).dot(b - a) / squared, 0.0, 1.0) : 0.0;
  return (x - a - t * (b - a)).norm();
}

// Each voxel against the distance of its middle from the bodies' surface, negative inside.
template <class Distance>
void expectVoxels(const VoxelSet& voxels, const Distance& distance) {
  std::size_t wrong = 0, inside = 0;
  for (std::size_t z = 0; z < voxels.size()[2]; ++z) {
    for (std::size_t y = 0; y < voxels.size()[1]; ++y) {
      for (std::size_t x = 0; x < voxels.size()[0]; ++x) {
        const double value = distance(voxels.middle(x, y, z));
        inside += voxels.contains(x, y, z);
        if (std::abs(value) > kOnBorder) wrong += voxels.contains(x, y, z) != (value < 0.0);
      }
    }
  }
  EXPECT_EQ(wrong, 0U);
  EXPECT_EQ(voxels.count(), inside);
}

TEST(VoxelSet, ofCapsulesAgainstBruteForce) {
  std::mt19937_64 random(1);
  for (int i = 0; i < 30; ++i) {
    VoxelSet voxels(cube(0.05), 0.0023);
    Eigen::Vector3d a = 0.06 * randomPoint(random), b = 0.06 * randomPoint(random);  // some reach outside
    if (i % 5 == 0) b = a;
    if (i % 5 == 1) b = a + Eigen::Vector3d(0.03, 0.0, 0.0);  // along the lines
    if (i % 5 == 2) b.x() = a.x();                            // across them
    const double radius = 0.002 + 0.0005 * i;
    voxels.addCapsule(a, b, radius);
    expectVoxels(voxels, [&](const Eigen::Vector3d& x) { return segmentDistance(x, a, b) - radius; });
  }
}

TEST(VoxelSet, ofATubeAgainstBruteForce) {
  std::mt19937_64 random(2);
  std::vector<Eigen::Vector3d> points;
  for (int i = 0; i < 20; ++i) points.push_back(0.04 * randomPoint(random));
  VoxelSet voxels(cube(0.05), 0.002);
  voxels.addTube(points, 0.003);
  expectVoxels(voxels, [&](const Eigen::Vector3d& x) {
    double nearest = std::numeric_limits<double>::infinity();
    for (std::size_t i = 1; i < points.size(); ++i) {
      nearest = std::min(nearest, segmentDistance(x, points[i - 1], points[i]));
    }
    return nearest - 0.003;
  });
}

TEST(VoxelSet, ofBodiesAgainstBruteForce) {
  std::mt19937_64 random(3);
  for (int i = 0; i < 20; ++i) {
    std::vector<Eigen::Vector3d> points;
    for (int k = 0; k <= i; ++k) points.push_back(0.04 * randomPoint(random));
    const RoundedHull body = {ConvexHull(points), 0.01 * (i % 3) / 2.0};
    VoxelSet voxels(cube(0.05), 0.0021);
    voxels.addBody(body);
    expectVoxels(voxels,
                 [&](const Eigen::Vector3d& x) { return body.core.closest(x).distance - body.radius; });
  }
}

// The number of lattice points in a convex body differs from its volume by less than the shell of half a
// diagonal about its surface; by chance far less.
TEST(VoxelSet, volumes) {
  const double edge = 0.0005, radius = 0.01;
  const Eigen::Vector3d half(0.01, 0.007, -0.004);
  VoxelSet ball(cube(0.03), edge);
  ball.addTube({0.3 * half}, radius);
  const double ball_volume = 4.0 / 3.0 * M_PI * std::pow(radius, 3);
  EXPECT_NEAR(ball.volume() / ball_volume, 1.0, 0.1 * 4.0 * M_PI * radius * radius * edge / ball_volume);

  VoxelSet capsule(cube(0.03), edge);
  capsule.addCapsule(-half, half, radius);
  const double capsule_volume = ball_volume + M_PI * radius * radius * 2.0 * half.norm();
  EXPECT_NEAR(capsule.volume() / capsule_volume, 1.0, 0.005);

  // The same as a body, but for middles that are as close to the border as rounding.
  VoxelSet body(cube(0.03), edge);
  body.addBody({ConvexHull({-half, half}), radius});
  EXPECT_NEAR(body.volume() / capsule.volume(), 1.0, 2e-4);  // a line's body is 1e-6 m thick

  VoxelSet both = ball;
  both.unite(capsule);  // which holds the ball
  EXPECT_EQ(both.count(), capsule.count());
  VoxelSet neither(cube(0.03), edge);
  EXPECT_EQ(neither.count(), 0U);
  neither.addCapsule({1.0, 1.0, 1.0}, {1.0, 1.0, 2.0}, radius);
  EXPECT_EQ(neither.count(), 0U);
}

TEST(VoxelSet, refusesGridsThatAreNone) {
  EXPECT_THROW(VoxelSet(Box(), 0.001), std::invalid_argument);
  EXPECT_THROW(VoxelSet(cube(0.0), 0.001), std::invalid_argument);
  EXPECT_THROW(VoxelSet(cube(0.1), 0.0), std::invalid_argument);
  EXPECT_THROW(VoxelSet(cube(0.1), std::numeric_limits<double>::quiet_NaN()), std::invalid_argument);
  EXPECT_THROW(VoxelSet(cube(1.0), 1e-5), std::invalid_argument);
  VoxelSet set(cube(0.1), 0.01);
  EXPECT_THROW(set.unite(VoxelSet(cube(0.1), 0.02)), std::invalid_argument);
}

}  // namespace
}  // namespace cable_variation
