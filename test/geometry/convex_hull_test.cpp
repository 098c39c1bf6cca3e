#include <cable_variation/geometry/body/convex_hull.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <stdexcept>
#include <thread>

#include <Eigen/Dense>
#include <gtest/gtest.h>

#include "geometry/closed_surface.h"
#include "geometry/test_points.h"

namespace cable_variation {
namespace {

Points corners(const Eigen::Vector3d& size) {
  Points points;
  for (int i = 0; i < 8; ++i) {
    points.emplace_back((i & 1 ? 0.5 : -0.5) * size.x(), (i & 2 ? 0.5 : -0.5) * size.y(),
                        (i & 4 ? 0.5 : -0.5) * size.z());
  }
  return points;
}

// Distance to a triangle by its six kinds of places, each a linear system: interior, edges, corners.
double triangleDistance(const Eigen::Vector3d& x, const Points& t) {
  double nearest = std::numeric_limits<double>::infinity();
  Eigen::Matrix<double, 3, 2> span;
  span << t[1] - t[0], t[2] - t[0];
  const Eigen::Vector2d weights = span.colPivHouseholderQr().solve(x - t[0]);
  if (weights.minCoeff() >= 0.0 && weights.sum() <= 1.0) nearest = (x - t[0] - span * weights).norm();
  for (std::size_t i = 0; i < 3; ++i) {
    const Eigen::Vector3d& a = t[i];
    const Eigen::Vector3d edge = t[(i + 1) % 3] - a;
    const double length = edge.squaredNorm();
    const double along = length > 0.0 ? std::clamp((x - a).dot(edge) / length, 0.0, 1.0) : 0.0;
    nearest = std::min(nearest, (x - a - along * edge).norm());
  }
  return nearest;
}

double surfaceDistance(const Eigen::Vector3d& x, const TriangleMesh& mesh) {
  double nearest = std::numeric_limits<double>::infinity();
  for (const auto& t : mesh.triangles) {
    nearest = std::min(nearest,
                       triangleDistance(x, {mesh.vertices[t[0]], mesh.vertices[t[1]], mesh.vertices[t[2]]}));
  }
  return nearest;
}

// Closed, holds all points to a few roundings of their coordinates, and its vertices are those it names.
void expectHullOf(const Points& points, const ConvexHull& hull, const char* what) {
  SCOPED_TRACE(what);
  EXPECT_EQ(surfaceFault(hull.surface()), "");
  EXPECT_EQ(eulerCharacteristic(hull.surface()), 2);
  EXPECT_GT(hull.volume(), 0.0);
  ASSERT_EQ(hull.sources().size(), hull.surface().vertices.size());
  for (std::size_t i = 0; i < hull.sources().size(); ++i) {
    if (hull.sources()[i] != ConvexHull::kAdded) {
      EXPECT_EQ(points.at(hull.sources()[i]), hull.surface().vertices[i]);
    }
  }
  double scale = 0.0, highest = -std::numeric_limits<double>::infinity();
  for (const Eigen::Vector3d& point : points) {
    scale = std::max(scale, point.cwiseAbs().maxCoeff());
    highest = std::max(highest, hull.height(point));
  }
  EXPECT_LE(highest, 1e-14 * std::max(scale, 1e-6));
}

// Against brute force over all triangles, and a separating or a containing plane.
void expectClosest(const ConvexHull& hull, const Eigen::Vector3d& x, double accuracy) {
  const ConvexHull::Closest closest = hull.closest(x);
  const double height = hull.height(x);
  ASSERT_NEAR(std::abs(closest.distance), surfaceDistance(x, hull.surface()), accuracy) << x.transpose();
  EXPECT_EQ(closest.distance > 0.0, height > 0.0);
  EXPECT_LE(height, closest.distance + accuracy);
  EXPECT_NEAR((x - closest.point).norm(), std::abs(closest.distance), accuracy);
  const auto& t = hull.surface().triangles.at(closest.triangle);
  const auto& vertices = hull.surface().vertices;
  EXPECT_NEAR(triangleDistance(closest.point, {vertices[t[0]], vertices[t[1]], vertices[t[2]]}), 0.0,
              accuracy);
}

TEST(ConvexHull, ofABox) {
  const Eigen::Vector3d size(0.2, 0.1, 0.05);
  Points points = corners(size);
  points.emplace_back(0.01, 0.02, 0.005);  // inside
  const ConvexHull hull(points);
  expectHullOf(points, hull, "box");
  EXPECT_EQ(hull.surface().vertices.size(), 8U);
  EXPECT_EQ(hull.surface().triangles.size(), 12U);
  EXPECT_NEAR(hull.volume(), 0.001, 1e-17);
  EXPECT_EQ(hull.sources(), (std::vector<std::size_t>{0, 1, 2, 3, 4, 5, 6, 7}));

  std::mt19937_64 random(1);
  for (int i = 0; i < 2000; ++i) {
    const Eigen::Vector3d x = 0.2 * randomPoint(random);
    const Eigen::Vector3d beyond = x.cwiseAbs() - 0.5 * size;
    const double exact = beyond.maxCoeff() > 0.0 ? beyond.cwiseMax(0.0).norm() : beyond.maxCoeff();
    EXPECT_NEAR(hull.closest(x).distance, exact, 1e-16) << x.transpose();
    EXPECT_NEAR(hull.height(x), beyond.maxCoeff(), 1e-16) << x.transpose();
  }
}

TEST(ConvexHull, ofRandomPointsAgainstBruteForce) {
  std::mt19937_64 random(2);
  for (const std::size_t count : {4, 5, 10, 100, 1000}) {
    Points points;
    for (std::size_t i = 0; i < count; ++i) points.push_back(randomPoint(random));
    const ConvexHull hull(points);
    expectHullOf(points, hull, "random");
    for (int i = 0; i < 300; ++i) expectClosest(hull, 2.0 * randomPoint(random), 1e-14);
  }
}

// The volume of a simplex is a determinant.
TEST(ConvexHull, volumeOfASimplex) {
  std::mt19937_64 random(3);
  for (int i = 0; i < 100; ++i) {
    Points points;
    for (int k = 0; k < 4; ++k) points.push_back(randomPoint(random));
    Eigen::Matrix3d edges;
    edges << points[1] - points[0], points[2] - points[0], points[3] - points[0];
    EXPECT_NEAR(ConvexHull(points).volume(), std::abs(edges.determinant()) / 6.0, 1e-15);
  }
}

// A lattice has all its outer points on faces and edges of the hull, and many in a line.
TEST(ConvexHull, ofALattice) {
  const Eigen::Matrix3d turn =
      Eigen::Quaterniond(Eigen::Vector4d(0.1, 0.5, -0.3, 0.8).normalized()).toRotationMatrix();
  for (const Eigen::Matrix3d& rotation : {Eigen::Matrix3d(Eigen::Matrix3d::Identity()), turn}) {
    Points points;
    for (int i = 0; i < 1000; ++i) {
      points.emplace_back(rotation * Eigen::Vector3d(i % 10, i / 10 % 10, i / 100) / 9.0);
    }
    const ConvexHull hull(points);
    expectHullOf(points, hull, "lattice");
    EXPECT_NEAR(hull.volume(), 1.0, 1e-14);
    std::mt19937_64 random(4);
    for (int i = 0; i < 500; ++i) {
      const Eigen::Vector3d x = 1.5 * randomPoint(random) + Eigen::Vector3d::Constant(0.5);
      const Eigen::Vector3d beyond = (x.array() - 0.5).abs() - 0.5;
      const double exact = beyond.maxCoeff() > 0.0 ? beyond.cwiseMax(0.0).norm() : beyond.maxCoeff();
      EXPECT_NEAR(hull.closest(rotation * x).distance, exact, 1e-14);
    }
  }
}

TEST(ConvexHull, ofManyPointsOnASphere) {
  std::mt19937_64 random(5);
  Points points;
  for (int i = 0; i < 10000; ++i) points.push_back(randomPoint(random).normalized());
  const ConvexHull hull(points);
  expectHullOf(points, hull, "sphere");
  EXPECT_EQ(hull.surface().vertices.size(), 10000U);
  // 2N - 4 facets of mean area 4π/2N: circumradii about 0.02, so a sagitta of 2e-4; ten times that for
  // uneven ones.
  EXPECT_LT(hull.volume(), 4.0 / 3.0 * M_PI);
  EXPECT_GT(hull.volume(), 4.0 / 3.0 * M_PI * 0.998);
  for (int i = 0; i < 30; ++i) expectClosest(hull, 1.5 * randomPoint(random), 1e-14);
}

TEST(ConvexHull, farFromTheOrigin) {
  std::mt19937_64 random(6);
  const Eigen::Vector3d far(100.0, -70.0, 30.0);
  Points points;
  for (int i = 0; i < 300; ++i) points.push_back(far + 0.01 * randomPoint(random));
  const ConvexHull hull(points);
  expectHullOf(points, hull, "far");
  for (int i = 0; i < 300; ++i) expectClosest(hull, far + 0.02 * randomPoint(random), 1e-13);
}

TEST(ConvexHull, tiny) {
  const Points points = corners(Eigen::Vector3d::Constant(1e-6));
  const ConvexHull hull(points);
  expectHullOf(points, hull, "tiny");
  EXPECT_NEAR(hull.volume() / 1e-18, 1.0, 1e-12);
  EXPECT_NEAR(hull.closest({0.0, 0.0, 1e-3}).distance, 1e-3 - 0.5e-6, 1e-18);
}

TEST(ConvexHull, ofPointsInAPlaneGetsABody) {
  std::mt19937_64 random(7);
  for (const double extent : {1e-6, 0.01, 1.0, 100.0}) {
    const Eigen::Vector3d normal = randomPoint(random).normalized();
    Points points;
    for (int i = 0; i < 200; ++i) {
      const Eigen::Vector3d point = randomPoint(random);
      points.push_back(extent * (point - point.dot(normal) * normal));
    }
    const ConvexHull hull(points);
    expectHullOf(points, hull, "plane");
    EXPECT_EQ(std::count(hull.sources().begin(), hull.sources().end(), ConvexHull::kAdded), 2);
    // 1e-6 m, or 1e-7 of the diameter: as the header says
    for (std::size_t i = 0; i < hull.sources().size(); ++i) {
      if (hull.sources()[i] == ConvexHull::kAdded) {
        EXPECT_LE(std::abs(normal.dot(hull.surface().vertices[i])),
                  std::max(1e-6, 1e-7 * 2.0 * std::sqrt(3.0) * extent) * 1.001);
      }
    }
  }
}

TEST(ConvexHull, ofPointsOnALineGetsABody) {
  std::mt19937_64 random(8);
  for (const double length : {1e-6, 0.01, 10.0}) {
    const Eigen::Vector3d direction = randomPoint(random).normalized();
    Points points;
    for (int i = 0; i < 50; ++i) points.push_back((i * 0.02 * length) * direction);
    const ConvexHull hull(points);
    expectHullOf(points, hull, "line");
    std::vector<std::size_t> sources = hull.sources();
    EXPECT_EQ(std::count(sources.begin(), sources.end(), ConvexHull::kAdded), 4);
    EXPECT_EQ(std::count(sources.begin(), sources.end(), 0U), 1);
    EXPECT_EQ(std::count(sources.begin(), sources.end(), 49U), 1);
    // off the end: the distance to the last point
    const Eigen::Vector3d beyond = 2.0 * length * direction;
    EXPECT_NEAR(hull.closest(beyond).distance, (beyond - points.back()).norm(), 1e-15 * length);
  }
}

TEST(ConvexHull, ofOnePointGetsABody) {
  const Eigen::Vector3d point(0.3, -0.2, 0.1);
  for (const Points& points : {Points{point}, Points(1000, point)}) {
    const ConvexHull hull(points);
    expectHullOf(points, hull, "point");
    EXPECT_EQ(hull.sources().size(), 4U);
    EXPECT_NEAR(hull.closest(point + Eigen::Vector3d(0.0, 0.0, -0.01)).distance, 0.01, 1e-15);
    EXPECT_NEAR(hull.closest(point + Eigen::Vector3d(0.0, 0.0, 0.01)).distance, 0.01 - 1e-6, 1e-15);
  }
}

TEST(ConvexHull, duplicatesAddNothing) {
  Points points = corners(Eigen::Vector3d::Ones());
  const Points once = points;
  for (int i = 0; i < 20; ++i) points.insert(points.end(), once.begin(), once.end());
  const ConvexHull hull(points);
  expectHullOf(points, hull, "duplicates");
  EXPECT_EQ(hull.surface().vertices.size(), 8U);
  EXPECT_NEAR(hull.volume(), 1.0, 1e-15);
}

// What envelopes are made of: control points of a stretch in many shapes that differ by little, in all
// thicknesses from none to that of a body, about a straight or a curved line, and some shapes given twice.
TEST(ConvexHull, ofShapesThatNearlyAgree) {
  std::mt19937_64 random(9);
  for (double spread = 1e-16; spread < 0.1; spread *= 3.0) {
    for (const double bend : {0.0, 1e-9, 0.1}) {
      for (const int directions : {1, 2, 3}) {
        Points points;
        const Eigen::Matrix3d turn =
            Eigen::AngleAxisd(3.0 * randomPoint(random).x(), randomPoint(random).normalized())
                .toRotationMatrix();
        for (int shape = 0; shape < 40; ++shape) {
          Eigen::Vector3d shift = Eigen::Vector3d::Zero();
          shift.head(directions) = spread * randomPoint(random).head(directions);
          for (int k = 0; k <= 15; ++k) {
            const double s = k / 15.0;
            const Eigen::Vector3d line(0.02 * s, bend * 0.02 * s * s, 0.0);
            points.push_back(Eigen::Vector3d(0.4, 0.3, -0.2) + turn * (line + s * shift));
            if (shape % 7 == 0) points.push_back(points.back());
          }
        }
        const ConvexHull hull(points);
        expectHullOf(points, hull, "shapes");
        for (int i = 0; i < 10; ++i) {
          expectClosest(hull, points[0] + 0.03 * randomPoint(random), 1e-14);
        }
      }
    }
  }
}

TEST(ConvexHull, inSeveralThreadsIsTheSame) {
  std::mt19937_64 random(10);
  Points points;
  for (int i = 0; i < 2000; ++i) points.push_back(randomPoint(random).normalized());
  const ConvexHull expected(points);
  std::vector<std::thread> threads;
  std::vector<int> different(4, 0);
  for (std::size_t i = 0; i < different.size(); ++i) {
    threads.emplace_back([&, i] {
      for (int k = 0; k < 5; ++k) {
        const ConvexHull hull(points);
        different[i] += hull.surface().triangles != expected.surface().triangles;
        different[i] += hull.planes() != expected.planes();
      }
    });
  }
  for (std::thread& thread : threads) thread.join();
  EXPECT_EQ(different, std::vector<int>(4, 0));
}

TEST(ConvexHull, refusesPointsThatAreNone) {
  EXPECT_THROW(ConvexHull(Points{}), std::invalid_argument);
  for (const double bad :
       {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
    Points points = corners(Eigen::Vector3d::Ones());
    points[5].y() = bad;
    EXPECT_THROW(ConvexHull{points}, std::invalid_argument);
  }
}

}  // namespace
}  // namespace cable_variation
