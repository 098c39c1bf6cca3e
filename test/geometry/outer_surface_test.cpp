#include <cable_variation/geometry/body/outer_surface.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>
#include <random>
#include <stdexcept>

#include <gtest/gtest.h>

#include "geometry/closed_surface.h"
#include "geometry/test_points.h"

namespace cable_variation {
namespace {

std::vector<const RoundedHull*> pointers(const std::vector<RoundedHull>& bodies) {
  std::vector<const RoundedHull*> all;
  for (const RoundedHull& body : bodies) all.push_back(&body);
  return all;
}

double distance(const Eigen::Vector3d& x, const std::vector<RoundedHull>& bodies) {
  double smallest = std::numeric_limits<double>::infinity();
  for (const RoundedHull& body : bodies) {
    smallest = std::min(smallest, body.core.closest(x).distance - body.radius);
  }
  return smallest;
}

RoundedHull capsule(const Eigen::Vector3d& from, const Eigen::Vector3d& to, double radius) {
  return {ConvexHull({from, to}), radius};
}

RoundedHull box(const Eigen::Vector3d& low, const Eigen::Vector3d& high, double radius) {
  Points points;
  for (int i = 0; i < 8; ++i) {
    points.emplace_back((i & 1 ? high : low).x(), (i & 2 ? high : low).y(), (i & 4 ? high : low).z());
  }
  return {ConvexHull(points), radius};
}

// Capsules around a circle of the radius 30 mm.
std::vector<RoundedHull> ring(double radius) {
  std::vector<RoundedHull> bodies;
  constexpr int kSides = 24;
  const auto corner = [&](int i) {
    return Eigen::Vector3d(0.03 * std::cos(2.0 * M_PI * i / kSides), 0.03 * std::sin(2.0 * M_PI * i / kSides),
                           0.0);
  };
  for (int i = 0; i < kSides; ++i) bodies.push_back(capsule(corner(i), corner(i + 1), radius));
  return bodies;
}

// Walls of a cube with an edge of 40 mm, 4 mm thick.
std::vector<RoundedHull> hollowCube() {
  std::vector<RoundedHull> bodies;
  for (int axis = 0; axis < 3; ++axis) {
    for (const double side : {-0.02, 0.02}) {
      Eigen::Vector3d low = Eigen::Vector3d::Constant(-0.02), high = -low;
      low[axis] = high[axis] = side;
      bodies.push_back(box(low, high, 0.002));
    }
  }
  return bodies;
}

// A point of the mesh's triangles is nowhere inside a body: so the bodies lie on one side of it.
void expectEncloses(const OuterSurface& surface, const std::vector<RoundedHull>& bodies) {
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> share(0.0, 1.0);
  double lowest = std::numeric_limits<double>::infinity();
  for (const auto& [a, b, c] : surface.mesh.triangles) {
    double u = share(random), v = share(random);
    if (u + v > 1.0) {
      u = 1.0 - u;
      v = 1.0 - v;
    }
    const auto& vertices = surface.mesh.vertices;
    lowest = std::min(
        lowest,
        distance(vertices[a] + u * (vertices[b] - vertices[a]) + v * (vertices[c] - vertices[a]), bodies));
  }
  EXPECT_GE(lowest, 0.0);
  double highest = 0.0;
  for (const Eigen::Vector3d& vertex : surface.mesh.vertices) {
    const double value = distance(vertex, bodies);
    EXPECT_GE(value, 0.0);
    highest = std::max(highest, value);
  }
  EXPECT_NEAR(surface.excess, highest, 1e-12);
}

// For a single body the linear function overestimates its distance, so the vertices are no further out than
// √(r² + 3h²/4) - r, and twice the 0.002 h by which values are moved off the level.
double boundOf(double radius, double cell) {
  return std::sqrt(radius * radius + 0.75 * cell * cell) - radius + 0.004 * cell;
}

TEST(OuterSurface, ofASphere) {
  const std::vector<RoundedHull> bodies = {{ConvexHull({Eigen::Vector3d(0.1, 0.2, 0.3)}), 0.01}};
  for (const double excess : {1e-3, 1e-4, 2e-5}) {
    OuterSurfaceOptions options;
    options.excess = excess;
    const OuterSurface surface = outerSurface(pointers(bodies), options);
    EXPECT_EQ(surfaceFault(surface.mesh), "");
    EXPECT_EQ(eulerCharacteristic(surface.mesh), 2);
    EXPECT_EQ(surface.components, 1U);
    expectEncloses(surface, bodies);
    EXPECT_NEAR(boundOf(0.01, surface.cell), excess + 0.004 * surface.cell, 1e-12);
    EXPECT_LE(surface.excess, boundOf(0.01, surface.cell));
    // between the sphere and one with the excess all around (and the 1e-6 m of a point's body)
    const double volume = enclosedVolume(surface.mesh);
    EXPECT_GE(volume, 4.0 / 3.0 * M_PI * std::pow(0.01, 3));
    EXPECT_LE(volume, 4.0 / 3.0 * M_PI * std::pow(0.01 + 1e-6 + surface.excess, 3));
  }
}

TEST(OuterSurface, ofACapsuleAndABox) {
  const std::vector<RoundedHull> slanted = {capsule({0.0, 0.0, 0.0}, {0.05, 0.03, 0.01}, 0.004)};
  const std::vector<RoundedHull> rounded = {box({-0.03, -0.01, 0.0}, {0.02, 0.02, 0.04}, 0.003)};
  const double length = std::sqrt(0.0035), r = 0.003;
  const double capsule_volume = M_PI * 0.004 * 0.004 * (length + 4.0 / 3.0 * 0.004);
  // Steiner: volume, surface, edges and corners
  const double box_volume = 0.05 * 0.03 * 0.04 + 2.0 * r * (0.05 * 0.03 + 0.03 * 0.04 + 0.05 * 0.04) +
                            M_PI * r * r * (0.05 + 0.03 + 0.04) + 4.0 / 3.0 * M_PI * r * r * r;
  for (const auto& [bodies, volume] : {std::pair(slanted, capsule_volume), std::pair(rounded, box_volume)}) {
    OuterSurfaceOptions options;
    options.excess = 1e-4;
    const OuterSurface surface = outerSurface(pointers(bodies), options);
    EXPECT_EQ(surfaceFault(surface.mesh), "");
    EXPECT_EQ(eulerCharacteristic(surface.mesh), 2);
    expectEncloses(surface, bodies);
    EXPECT_LE(surface.excess, boundOf(bodies.front().radius, surface.cell));
    EXPECT_GE(enclosedVolume(surface.mesh), volume);
    // At most the excess thicker everywhere: that is 2/r of it for a thin cylinder, 3/r for a ball.
    EXPECT_LE(enclosedVolume(surface.mesh), volume * (1.0 + 3.0 * surface.excess / r));
  }
}

TEST(OuterSurface, ofARingHasAHole) {
  const std::vector<RoundedHull> bodies = ring(0.004);
  const OuterSurface surface = outerSurface(pointers(bodies));
  EXPECT_EQ(surfaceFault(surface.mesh), "");
  EXPECT_EQ(eulerCharacteristic(surface.mesh), 0);
  EXPECT_EQ(surface.components, 1U);
  EXPECT_EQ(surface.filled_voids, 0U);
  expectEncloses(surface, bodies);
  // Pappus, with the capsules' chords shorter than the circle's arcs by 1 - cos(π/24) < 1 %
  const double torus = 2.0 * M_PI * 0.03 * M_PI * 0.004 * 0.004;
  EXPECT_NEAR(enclosedVolume(surface.mesh) / torus, 1.0, 0.01 + 2.0 * surface.excess / 0.004);
}

TEST(OuterSurface, fillsWhatCannotBeReached) {
  std::vector<RoundedHull> bodies = hollowCube();
  bodies.push_back({ConvexHull({Eigen::Vector3d(0.001, 0.002, -0.003)}), 0.003});  // floats in the void
  OuterSurfaceOptions options;
  options.excess = 1e-4;
  const OuterSurface surface = outerSurface(pointers(bodies), options);
  EXPECT_EQ(surfaceFault(surface.mesh), "");
  EXPECT_EQ(surface.components, 1U);
  EXPECT_EQ(surface.filled_voids, 1U);
  EXPECT_EQ(eulerCharacteristic(surface.mesh), 2);
  EXPECT_GE(enclosedVolume(surface.mesh), std::pow(0.04, 3));

  // With a wall gone, the inside is seen.
  bodies.erase(bodies.begin());
  const OuterSurface open = outerSurface(pointers(bodies), options);
  EXPECT_EQ(open.components, 2U);
  EXPECT_EQ(open.filled_voids, 0U);
  EXPECT_EQ(eulerCharacteristic(open.mesh), 4);
  // less than six walls side by side, far less than the cube
  EXPECT_LT(enclosedVolume(open.mesh), 6.0 * 0.044 * 0.044 * 0.004);
}

TEST(OuterSurface, keepsSeveralCables) {
  std::vector<RoundedHull> bodies;
  for (const double y : {0.0, 0.02, 0.04}) bodies.push_back(capsule({0.0, y, 0.0}, {0.1, y, 0.0}, 0.002));
  const OuterSurface surface = outerSurface(pointers(bodies));
  EXPECT_EQ(surface.components, 3U);
  EXPECT_EQ(eulerCharacteristic(surface.mesh), 6);
  EXPECT_EQ(surfaceFault(surface.mesh), "");
}

// Stretches of a cable that bends and spreads: convex bodies that overlap at flat angles, as in an envelope.
std::vector<RoundedHull> spreadCable(std::size_t stretches, std::size_t phases, std::mt19937_64& random) {
  std::vector<RoundedHull> bodies;
  for (std::size_t phase = 0; phase < phases; ++phase) {
    const Eigen::Vector3d sweep = 0.004 * randomPoint(random);
    for (std::size_t i = 0; i < stretches; ++i) {
      Points points;
      for (int k = 0; k <= 10; ++k) {
        const double s = (static_cast<double>(i) + k / 10.0) / static_cast<double>(stretches);
        const Eigen::Vector3d middle(0.3 * s, 0.05 * std::sin(5.0 * s), 0.04 * std::cos(3.0 * s));
        for (int direction = 0; direction < 10; ++direction) {
          const Eigen::Vector3d off =
              0.004 * std::sin(M_PI * s) *
              Eigen::Vector3d(0.3 * std::sin(direction), std::cos(direction), std::sin(2.0 * direction));
          points.push_back(middle + sweep * s + off);
        }
      }
      bodies.push_back({ConvexHull(points), 0.004});
    }
  }
  return bodies;
}

TEST(OuterSurface, ofAnEnvelope) {
  std::mt19937_64 random(2);
  const std::vector<RoundedHull> bodies = spreadCable(30, 2, random);
  OuterSurfaceOptions options;
  options.triangles = 12000;
  const OuterSurface surface = outerSurface(pointers(bodies), options);
  EXPECT_EQ(surfaceFault(surface.mesh), "");
  EXPECT_EQ(surface.components, 1U);
  EXPECT_NEAR(static_cast<double>(surface.mesh.triangles.size()), 12000.0, 0.4 * 12000.0);
  expectEncloses(surface, bodies);

  options.threads = 1;
  const OuterSurface alone = outerSurface(pointers(bodies), options);
  EXPECT_EQ(alone.mesh.triangles, surface.mesh.triangles);
  EXPECT_EQ(alone.mesh.vertices, surface.mesh.vertices);
}

TEST(OuterSurface, refusesWhatIsNone) {
  const std::vector<RoundedHull> bodies = {{ConvexHull({Eigen::Vector3d::Zero()}), 0.01}};
  EXPECT_THROW(outerSurface({}), std::invalid_argument);
  for (const double bad : {-1e-4, std::numeric_limits<double>::quiet_NaN()}) {
    OuterSurfaceOptions options;
    options.excess = bad;
    EXPECT_THROW(outerSurface(pointers(bodies), options), std::invalid_argument);
    const RoundedHull bad_body = {ConvexHull({Eigen::Vector3d::Zero()}), bad};
    EXPECT_THROW(outerSurface({&bad_body}), std::invalid_argument);
  }
  OuterSurfaceOptions none;
  none.triangles = 0;
  EXPECT_THROW(outerSurface(pointers(bodies), none), std::invalid_argument);
  OuterSurfaceOptions fine;
  fine.excess = 1e-14;
  EXPECT_THROW(outerSurface(pointers(bodies), fine), std::invalid_argument);
}

// What is too fine for the memory allowed is made as fine as that is enough for.
TEST(OuterSurface, KeepsToItsMemory) {
  const std::vector<RoundedHull> bodies = {capsule({0.0, 0.0, 0.0}, {0.05, 0.03, 0.01}, 0.004)};
  OuterSurfaceOptions options;
  options.excess = 1e-6;
  for (const double limit : {1e4, 1e6, 1e7}) {
    options.memory_limit = limit;
    const OuterSurface surface = outerSurface(pointers(bodies), options);
    EXPECT_TRUE(surface.coarsened) << limit;
    EXPECT_EQ(surfaceFault(surface.mesh), "");
    expectEncloses(surface, bodies);
    // at most the triangles that it is enough for, of which a few are always made
    constexpr double kBytesPerTriangle = 130.0;
    const auto triangles = static_cast<double>(surface.mesh.triangles.size());
    EXPECT_LE(kBytesPerTriangle * triangles, std::max(1.1 * limit, 8e5)) << limit;
    if (limit >= 1e6) {
      EXPECT_GE(kBytesPerTriangle * triangles, 0.4 * limit) << limit;
    }
  }
  options.excess = 1e-4;
  const OuterSurface exactly = outerSurface(pointers(bodies), options);
  EXPECT_FALSE(exactly.coarsened);
  options.memory_limit = std::numeric_limits<double>::infinity();
  EXPECT_EQ(outerSurface(pointers(bodies), options).mesh.triangles.size(), exactly.mesh.triangles.size());
  options.memory_limit = 0.0;
  EXPECT_THROW(outerSurface(pointers(bodies), options), std::invalid_argument);
}

// By the area of a capsule, before anything is made.
TEST(OuterSurface, WhatItTakesIsKnownBeforehand) {
  constexpr double kRadius = 0.004, kSide = 0.06;
  const std::vector<RoundedHull> bodies = {capsule({0.0, 0.0, 0.0}, {kSide, 0.0, 0.0}, kRadius)};
  const double area = 2.0 * M_PI * kRadius * (kSide + 2.0 * kRadius);
  for (const double excess : {1e-4, 2e-5}) {
    OuterSurfaceOptions options;
    options.excess = excess;
    const double triangles =
        static_cast<double>(outerSurface(pointers(bodies), options).mesh.triangles.size());
    const double taken = outerSurfaceMemory(area, kRadius, excess);
    EXPECT_NEAR(taken / triangles, 130.0, 15.0);
    EXPECT_NEAR(finestExcess(area, kRadius, taken), excess, 1e-9 * excess + 1e-15);
  }
}

TEST(OuterSurface, EndsWhenAskedTo) {
  const std::vector<RoundedHull> bodies = {capsule({0.0, 0.0, 0.0}, {0.05, 0.03, 0.01}, 0.004)};
  struct Enough {};
  OuterSurfaceOptions options;
  std::atomic<int> asked{0};
  options.check = [&] {
    if (++asked > 20) throw Enough();
  };
  EXPECT_THROW(outerSurface(pointers(bodies), options), Enough);
  EXPECT_LE(asked, 40);  // a few threads notice at once
}

}  // namespace
}  // namespace cable_variation
