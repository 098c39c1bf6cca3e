// Far from the origin, as in map coordinates, everything measures what it measures at the origin, to what is
// left of a double there: a step of 1.2e-10 m at a thousand kilometres.
#include <cable_variation/geometry/body/body_distance.h>
#include <cable_variation/geometry/body/outer_surface.h>
#include <cable_variation/geometry/body/primitives.h>
#include <cable_variation/geometry/body/voxel_set.h>
#include <cable_variation/geometry/tube_distance/distance.h>
#include <cable_variation/geometry/tube_distance/hausdorff.h>

#include <cmath>
#include <random>
#include <vector>

#include <gtest/gtest.h>

namespace cable_variation {
namespace {

using Eigen::Vector3d;

const Vector3d kFar(1e6, -2e6, 300.0);

// A bent cable about the origin, moved; its pieces are from points that both have.
Centreline cable(std::mt19937& random, const Vector3d& by, double wave = 0.1) {
  std::uniform_real_distribution<double> any(-1.0, 1.0);
  const Vector3d amplitude(wave * any(random), wave * any(random), wave * any(random));
  const double phase = 3.0 * any(random);
  const auto end = [&](double s) {
    CurvePiece::End e;
    e.position = by + Vector3d(s, 0.0, 0.0) + amplitude * std::sin(8.0 * s + phase);
    e.tangent = Vector3d::UnitX() + 8.0 * amplitude * std::cos(8.0 * s + phase);
    e.second_derivative = -64.0 * amplitude * std::sin(8.0 * s + phase);
    return e;
  };
  Centreline line;
  constexpr int kPieces = 20;
  constexpr double kStep = 0.025;
  for (int i = 0; i < kPieces; ++i) {
    line.pieces.push_back(
        {CurvePiece(end(kStep * i), end(kStep * (i + 1)), kStep), kStep * i, kStep * (i + 1), 4e-3, 5e-3});
  }
  return line;
}

std::vector<Vector3d> cloud(std::mt19937& random, const Vector3d& about, const Vector3d& by) {
  std::uniform_real_distribution<double> any(-0.05, 0.05);
  std::vector<Vector3d> points;
  for (int i = 0; i < 30; ++i) points.push_back(by + about + Vector3d(any(random), any(random), any(random)));
  return points;
}

// Runs `measure(random, by)` at the origin and far away, with the same random numbers.
template <class Measure>
void expectSame(double tolerance, const Measure& measure) {
  for (unsigned seed = 0; seed < 10; ++seed) {
    std::mt19937 here(seed), there(seed);
    const double near = measure(here, Vector3d(Vector3d::Zero()));
    EXPECT_NEAR(measure(there, kFar), near, tolerance) << "seed " << seed;
  }
}

TEST(MapCoordinates, distanceToAPart) {
  const DistancePart box(boxMesh({0.2, 0.1, 0.1})), ball(sphereMesh(0.05));
  for (const DistancePart* part : {&box, &ball}) {
    expectSame(2e-9, [&](std::mt19937& random, const Vector3d& by) {
      std::uniform_real_distribution<double> any(-0.2, 0.2);
      const Centreline line = cable(random, by);
      Pose pose;
      pose.position = by + Vector3d(0.25 + any(random), any(random), any(random));
      pose.orientation = Eigen::Quaterniond(1.0, any(random), any(random), any(random)).normalized();
      return distance(line, *part, pose)->distance;
    });
  }
}

TEST(MapCoordinates, distanceOfTwoCables) {
  expectSame(2e-9, [](std::mt19937& random, const Vector3d& by) {
    const Centreline a = cable(random, by);
    return distance(a, cable(random, by + Vector3d(0.0, 0.0, 0.03)))->distance;
  });
}

TEST(MapCoordinates, hausdorff) {
  constexpr double kWave = 0.02;
  expectSame(2e-7, [](std::mt19937& random, const Vector3d& by) {
    const Centreline a = cable(random, by, kWave);
    return curveHausdorff(a, cable(random, by, kWave)).distance;
  });
  expectSame(2e-6, [](std::mt19937& random, const Vector3d& by) {
    const Centreline a = cable(random, by, kWave);
    return surfaceHausdorff(a, cable(random, by, kWave)).distance;
  });
}

TEST(MapCoordinates, hullsAndBodies) {
  expectSame(1e-11, [](std::mt19937& random, const Vector3d& by) {
    return ConvexHull(cloud(random, Vector3d::Zero(), by)).volume();
  });
  expectSame(5e-9, [](std::mt19937& random, const Vector3d& by) {
    const ConvexHull hull(cloud(random, Vector3d::Zero(), by));
    return hull.closest(by + Vector3d(0.1, 0.02, 0.03)).distance + hull.height(by);
  });
  expectSame(2e-7, [](std::mt19937& random, const Vector3d& by) {
    const RoundedHull a{ConvexHull(cloud(random, Vector3d::Zero(), by)), 0.004};
    const RoundedHull b{ConvexHull(cloud(random, Vector3d(0.12, 0.05, 0.0), by)), 0.004};
    return distance({BodyCouple(&a, &b)})->distance;
  });
}

TEST(MapCoordinates, aFlatHull) {
  expectSame(1e-8, [](std::mt19937& random, const Vector3d& by) {
    std::vector<Vector3d> points = cloud(random, Vector3d::Zero(), by);
    for (Vector3d& point : points) point.z() = by.z();
    return ConvexHull(points).closest(by + Vector3d(0.0, 0.0, 0.05)).distance;
  });
}

TEST(MapCoordinates, outerSurface) {
  expectSame(1e-9, [](std::mt19937& random, const Vector3d& by) {
    const RoundedHull body{ConvexHull(cloud(random, Vector3d::Zero(), by)), 0.01};
    OuterSurfaceOptions options;
    options.excess = 1e-3;
    const OuterSurface surface = outerSurface({&body}, options);
    double furthest = 0.0;
    for (const Vector3d& vertex : surface.mesh.vertices) {
      furthest = std::max(furthest, std::abs(body.core.closest(vertex).distance - body.radius));
    }
    return furthest <= surface.excess + 1e-8 && surface.components == 1 ? 0.0 : 1.0;
  });
}

TEST(MapCoordinates, voxels) {
  expectSame(1e-6, [](std::mt19937& random, const Vector3d& by) {
    const RoundedHull body{ConvexHull(cloud(random, Vector3d::Zero(), by)), 0.01};
    Box box;
    box.low = (by - Vector3d::Constant(0.08)).array();
    box.high = (by + Vector3d::Constant(0.08)).array();
    VoxelSet voxels(box, 1e-3);
    voxels.addBody(body);
    return voxels.volume();
  });
}

}  // namespace
}  // namespace cable_variation
