// Polygons become triangles that cover the same, however many corners they have, and in bounded time.
#include <cable_variation/geometry/mesh/soup_builder.h>

#include <cmath>
#include <numeric>
#include <random>
#include <stdexcept>
#include <string>
#include <vector>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "cpu_time.h"

namespace cable_variation {
namespace {

using Outline = std::vector<Eigen::Vector2d>;

double areaOf(const Outline& outline) {
  double sum = 0.0;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const Eigen::Vector2d &a = outline[i], &b = outline[(i + 1) % outline.size()];
    sum += 0.5 * (a.x() * b.y() - a.y() * b.x());
  }
  return sum;
}

struct Divided {
  std::size_t triangles = 0;
  double area = 0.0;      // of all, each with its side
  double absolute = 0.0;  // of all, whatever their side
  double seconds = 0.0;
};

// In a plane that is not one of the axes'.
Divided divided(const Outline& outline) {
  const Eigen::Matrix3d turn =
      Eigen::AngleAxisd(0.7, Eigen::Vector3d(1.0, 2.0, 3.0).normalized()).toRotationMatrix();
  SoupBuilder builder;
  std::vector<std::uint32_t> corners;
  for (const Eigen::Vector2d& at : outline)
    corners.push_back(builder.vertex(turn * Eigen::Vector3d(at.x(), at.y(), 0.3)));
  const test::CpuTime start;
  builder.polygon(corners);
  Divided result;
  result.seconds = start.seconds();
  const TriangleMesh mesh = builder.take();
  result.triangles = mesh.triangles.size();
  for (const auto& [a, b, c] : mesh.triangles) {
    const Eigen::Vector3d normal =
        (mesh.vertices[b] - mesh.vertices[a]).cross(mesh.vertices[c] - mesh.vertices[a]);
    const double area = 0.5 * normal.dot(turn.col(2));
    result.area += area;
    result.absolute += std::abs(area);
  }
  return result;
}

Outline star(std::mt19937_64& random, std::size_t count, double depth) {
  std::uniform_real_distribution<double> share(1.0 - depth, 1.0);
  Outline outline;
  for (std::size_t i = 0; i < count; ++i) {
    const double angle = 2.0 * M_PI * static_cast<double>(i) / static_cast<double>(count);
    const double radius = share(random);
    outline.emplace_back(radius * std::cos(angle), radius * std::sin(angle));
  }
  return outline;
}

Outline circle(std::size_t count) {
  std::mt19937_64 random(1);
  return star(random, count, 0.0);
}

// A band that winds about its middle.
Outline spiral(std::size_t count) {
  Outline outer, inner;
  for (std::size_t i = 0; i < count / 2; ++i) {
    const double t = static_cast<double>(i) / static_cast<double>(count / 2), angle = 2.0 * M_PI * 5.0 * t;
    outer.emplace_back((1.0 + 4.0 * t) * std::cos(angle), (1.0 + 4.0 * t) * std::sin(angle));
    inner.emplace_back((0.6 + 4.0 * t) * std::cos(angle), (0.6 + 4.0 * t) * std::sin(angle));
  }
  outer.insert(outer.end(), inner.rbegin(), inner.rend());
  return outer;
}

// Teeth, half of whose corners turn inwards.
Outline comb(std::size_t teeth) {
  Outline outline{{0.0, -1.0}, {static_cast<double>(2 * teeth), -1.0}};
  for (std::size_t i = 2 * teeth; i > 0; --i) {
    outline.emplace_back(static_cast<double>(i), i % 2 == 0 ? 1.0 : 0.0);
  }
  outline.emplace_back(0.0, 1.0);
  return outline;
}

void expectCovers(const Outline& outline, const std::string& what) {
  const Divided result = divided(outline);
  const double area = areaOf(outline);
  EXPECT_EQ(result.triangles, outline.size() - 2) << what;
  EXPECT_NEAR(result.area, area, 1e-9 * std::abs(area)) << what;
  EXPECT_NEAR(result.absolute, area, 1e-9 * std::abs(area)) << what << ": triangles overlap";
}

TEST(Polygon, isCoveredByItsTriangles) {
  std::mt19937_64 random(11);
  for (int round = 0; round < 300; ++round) {
    const std::size_t count = 4 + random() % (round % 10 == 0 ? 400 : 30);
    expectCovers(star(random, count, 0.9), "star of " + std::to_string(count));
  }
  for (const std::size_t count : {10U, 60U, 1000U}) {
    expectCovers(circle(count), "circle");
    if (count > 10U)
      expectCovers(spiral(count), "spiral");  // with less than a corner a quarter turn it is none
    expectCovers(comb(count), "comb");
  }
}

TEST(Polygon, ofManyCornersTakesLittleTime) {
  for (const std::size_t count : {50000U, 200000U}) {
    const Divided result = divided(circle(count));
    EXPECT_EQ(result.triangles, count - 2);
    EXPECT_LT(result.seconds, 2.0) << count;
  }
  EXPECT_LT(divided(comb(2000)).seconds, 2.0);
  EXPECT_LT(divided(spiral(4000)).seconds, 2.0);
}

// Whatever cannot be divided in some seconds is refused then, a single polygon or many.
TEST(Polygon, thatTakesTooLongIsRefused) {
  std::mt19937_64 random(12);
  const test::CpuTime start;
  for (const Outline& outline : {comb(200000), spiral(200000), star(random, 200000, 0.9)}) {
    try {
      divided(outline);
    } catch (const std::invalid_argument& error) {
      EXPECT_NE(std::string(error.what()).find("corners that turn inwards"), std::string::npos);
    }
  }
  EXPECT_LT(start.seconds(), 60.0);
}

// Outlines that cross themselves, repeat corners or have no area have no triangles that are right: any, of
// their corners, and no more than there can be.
TEST(Polygon, ofAnySortEnds) {
  std::mt19937_64 random(13);
  std::uniform_real_distribution<double> coordinate(-1.0, 1.0);
  for (int round = 0; round < 2000; ++round) {
    SoupBuilder builder;
    const std::size_t count = 3 + random() % 40, points = 1 + random() % count;
    std::vector<std::uint32_t> vertices, corners;
    for (std::size_t i = 0; i < points; ++i) {
      const double x = coordinate(random), scale = round % 3 == 0 ? 1e-170 : round % 3 == 1 ? 1.0 : 1e150;
      vertices.push_back(
          builder.vertex(scale * Eigen::Vector3d(x, round % 4 == 0 ? x : coordinate(random), 0.0)));
    }
    for (std::size_t i = 0; i < count; ++i) corners.push_back(vertices[random() % points]);
    builder.polygon(corners);
    EXPECT_LE(builder.mesh().triangles.size(), count - 2);
  }
}

TEST(Polygon, trianglesAreLimited) {
  SoupBuilder builder(10);
  for (int i = 0; i < 12; ++i) builder.vertex({static_cast<double>(i), static_cast<double>(i * i), 0.0});
  for (std::uint32_t i = 0; i < 10; ++i) builder.polygon({i, i + 1, i + 2});
  try {
    builder.polygon({0, 1, 3});
    ADD_FAILURE() << "an eleventh triangle";
  } catch (const std::invalid_argument& error) {
    EXPECT_EQ(std::string(error.what()), "it has more triangles; expected at most 10 (the limit triangles)");
  }
}

}  // namespace
}  // namespace cable_variation
