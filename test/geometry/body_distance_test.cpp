#include <cable_variation/geometry/body/body_distance.h>

#include <cmath>
#include <stdexcept>

#include <gtest/gtest.h>

#include <cable_variation/geometry/body/placed_body.h>
#include <cable_variation/geometry/body/primitives.h>
#include <cable_variation/geometry/tube_distance/triangle_pair.h>
#include <geometry/body_oracle.h>

namespace cable_variation {
namespace {

using Eigen::Vector3d;
using test::Chance;
using test::Corners;

constexpr double kExact = 1e-7;  // promised [m]

BodyPair toPart(const RoundedHull& body, const TriangleMesh& mesh, const Pose& pose = Pose()) {
  return distance({&body}, DistancePart(mesh), pose).value();
}

TriangleMesh soup(Chance& chance, std::size_t count, double size, const Vector3d& middle, double spread) {
  TriangleMesh mesh;
  for (std::size_t i = 0; i < count; ++i) {
    const Vector3d at = middle + chance.inBox(spread);
    const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
    for (int k = 0; k < 3; ++k) mesh.vertices.push_back(at + chance.inBox(size));
    mesh.triangles.push_back({first, first + 1, first + 2});
  }
  return mesh;
}

// A box of 20 x 30 x 40 mm rounded by 5 mm below and beside boxes: the gap of the faces, and the root of the
// squared gaps along two or three axes.
TEST(BodyDistance, OfABoxToBoxes) {
  const RoundedHull body = test::boxBody({0.02, 0.03, 0.04}, 0.005);
  const TriangleMesh box = boxMesh({0.1, 0.1, 0.1});
  const auto at = [&](double x, double y, double z) {
    return toPart(body, box, {{x, y, z}, Eigen::Quaterniond::Identity()});
  };
  EXPECT_NEAR(at(0.08, 0.0, 0.0).distance, 0.08 - 0.05 - 0.01 - 0.005, 1e-15);
  EXPECT_NEAR(at(0.07, 0.08, 0.0).distance, std::hypot(0.01, 0.015) - 0.005, 1e-15);
  EXPECT_NEAR(at(0.07, 0.08, -0.1).distance, std::hypot(0.01, 0.015, 0.03) - 0.005, 1e-15);
  const BodyPair corner = at(0.07, 0.08, -0.1);
  const Vector3d direction = Vector3d(0.01, 0.015, -0.03).normalized();
  EXPECT_TRUE(corner.on_other.isApprox(Vector3d(0.02, 0.03, -0.05), 1e-12));
  EXPECT_TRUE(corner.on_body.isApprox(Vector3d(0.01, 0.015, -0.02) + 0.005 * direction, 1e-12));
}

// Rounded by more than the gap: the plate enters what is round, not the core.
TEST(BodyDistance, OverlapOfTheRoundedRimIsMinusItsDepth) {
  const RoundedHull body = test::boxBody({0.02, 0.02, 0.02}, 0.005);
  TriangleMesh plate;
  plate.vertices = {{0.013, -1, -1}, {0.013, 1, -1}, {0.013, 0, 1}};
  plate.triangles = {{0, 1, 2}};
  const BodyPair pair = toPart(body, plate);
  EXPECT_NEAR(pair.distance, 0.003 - 0.005, 1e-12);
  EXPECT_NEAR(pair.on_body.x(), 0.015, 1e-12);
  EXPECT_NEAR(pair.on_other.x(), 0.013, 1e-12);
}

// A plate through the core, 2 mm off the middle of a box of 40 x 40 x 20 mm: along the plate's x-y plane the
// deepest point is 10 - 2 mm below the upper face.
TEST(BodyDistance, OverlapOfTheCoreIsMinusTheDepthOfTheDeepestPoint) {
  const RoundedHull body = test::boxBody({0.04, 0.04, 0.02}, 0.003);
  TriangleMesh plate;
  plate.vertices = {{-1, -1, 0.002}, {1, -1, 0.002}, {0, 1, 0.002}};
  plate.triangles = {{0, 1, 2}};
  const BodyPair pair = toPart(body, plate);
  EXPECT_NEAR(pair.distance, -0.008 - 0.003, 1e-12);
  EXPECT_NEAR(pair.on_other.z(), 0.002, 1e-12);
  EXPECT_NEAR((pair.on_body - pair.on_other).norm(), 0.011, 1e-12);
}

// A cube of 2 mm in the middle of a box of 20 mm: its face towards a face is 9 mm below it, its own middle
// would be 10 mm.
TEST(BodyDistance, APartWhollyInsideOverlaps) {
  const RoundedHull body = test::boxBody({0.02, 0.04, 0.04}, 0.001);
  const BodyPair pair = toPart(body, boxMesh({0.002, 0.002, 0.002}));
  // the part's faces along y and z reach to x = 0
  EXPECT_NEAR(pair.distance, -0.010 - 0.001, 1e-12);
}

// A box of 2 mm, 6 mm below the upper face of one of 100 mm: its lower corners are 7 mm deep.
TEST(BodyDistance, ABodyWhollyInsideASolidOverlaps) {
  const RoundedHull body = test::boxBody({0.002, 0.002, 0.002}, 0.0005);
  const TriangleMesh box = boxMesh({0.1, 0.1, 0.1});
  const Pose pose{{0.0, 0.0, -0.044}, Eigen::Quaterniond::Identity()};
  const BodyPair pair = toPart(body, box, pose);
  EXPECT_NEAR(pair.distance, -0.007 - 0.0005, 1e-12);
  EXPECT_NEAR(pair.on_other.z(), 0.006, 1e-12);
  EXPECT_NEAR(pair.on_body.z(), -0.0015, 1e-12);

  TriangleMesh open = box;  // without one facet of twelve its winding number still tells
  open.triangles.erase(open.triangles.begin());
  EXPECT_NEAR(toPart(body, open, pose).distance, -0.007 - 0.0005, 1e-12);
  open.triangles.resize(4);  // without most of them there is no inside
  EXPECT_GT(toPart(body, open, pose).distance, 0.0);
}

// Half of a body 20 mm long is in a solid: surface 10 mm within the core lengthwise, but only 2 mm from its
// sides; corners 10 mm below the solid's face.
TEST(BodyDistance, ABodyPartlyInASolidOverlapsByTheDeeperOfBoth) {
  const RoundedHull body = test::boxBody({0.02, 0.004, 0.004}, 0.001);
  const BodyPair pair =
      toPart(body, boxMesh({0.1, 0.1, 0.1}), {{0.05, 0, 0}, Eigen::Quaterniond::Identity()});
  EXPECT_NEAR(pair.distance, -0.010 - 0.001, 1e-12);
}

TEST(BodyDistance, OfRandomBodiesAgreesWithBruteForce) {
  Chance chance(1);
  int clear = 0, round = 0, deep = 0;
  for (int i = 0; i < 80; ++i) {
    const double size = chance.size(1e-3, 0.1), radius = size * chance.size(0.01, 0.3);
    const RoundedHull body = test::randomBody(chance, 5 + chance.below(20), size, radius);
    const Vector3d middle = chance.inBox(chance.oneOf(2) ? 0.1 * size : 0.8 * size);
    const TriangleMesh mesh =
        soup(chance, 1 + chance.below(4), size * chance.size(1e-3, 10.0), middle, 0.1 * size);
    test::Real expected = std::numeric_limits<test::Real>::infinity();
    for (std::size_t k = 0; k < mesh.triangles.size(); ++k) {
      expected = std::min(expected, test::bodyDistance(body, test::cornersOf(mesh, k)));
    }
    const BodyPair pair = toPart(body, mesh);
    EXPECT_NEAR(pair.distance, static_cast<double>(expected), 1e-9 * size) << i;
    (expected > 0 ? clear : expected > -radius ? round : deep)++;
    EXPECT_NEAR((pair.on_body - pair.on_other).norm(), std::abs(pair.distance), 1e-9 * size) << i;
  }
  // each kind is there
  EXPECT_GT(clear, 10);
  EXPECT_GT(round, 5);
  EXPECT_GT(deep, 10);
}

// Triangles of 1 µm to 1 m, slivers, edges that are parallel to 1e-3 to 1e-15: the closest points of edges
// are where rounding is worst.
TEST(BodyDistance, OfTrianglesOfAllShapesIsExact) {
  Chance chance(2);
  for (int i = 0; i < 300; ++i) {
    std::array<Vector3d, 3> a, b;
    const double size = chance.size(1e-6, 1.0);
    for (Vector3d& corner : a) corner = chance.inBox(size);
    for (Vector3d& corner : b) corner = chance.inBox(size);
    if (chance.oneOf(3)) a[2] = 0.5 * (a[0] + a[1]) + chance.inBox(size * chance.size(1e-12, 1e-3));
    if (chance.oneOf(2)) {
      const Vector3d aside = chance.inBox(0.2 * size);
      b[0] = a[0] + aside + chance.inBox(size * chance.size(1e-15, 1e-3));
      b[1] = a[1] + aside + chance.inBox(size * chance.size(1e-15, 1e-3));
    }
    const auto real = [](const std::array<Vector3d, 3>& t) {
      return Corners{t[0].cast<test::Real>(), t[1].cast<test::Real>(), t[2].cast<test::Real>()};
    };
    const TrianglePair pair =
        closestPoints(SurfaceTriangle(a[0], a[1], a[2]), SurfaceTriangle(b[0], b[1], b[2]));
    EXPECT_NEAR(pair.distance, static_cast<double>(test::pairDistance(real(a), real(b))),
                1e-10 * size + 1e-15)
        << i;
  }
}

TEST(BodyDistance, DoesNotDependOnWhereAllOfItIs) {
  Chance chance(3);
  for (int i = 0; i < 30; ++i) {
    const RoundedHull body = test::randomBody(chance, 20, 0.03, 0.004);
    const TriangleMesh mesh = soup(chance, 30, 0.02, chance.inBox(0.03), 0.03);
    const Pose pose{chance.inBox(0.02), chance.orientation()}, moved{chance.inBox(1.0), chance.orientation()};
    std::vector<Vector3d> points;
    for (const Vector3d& vertex : body.core.surface().vertices) points.push_back(moved * vertex);
    const BodyPair here = toPart(body, mesh, pose);
    const BodyPair there = toPart({ConvexHull(points), body.radius}, mesh, moved * pose);
    EXPECT_NEAR(here.distance, there.distance, 1e-12) << i;
    EXPECT_LT((there.on_other - moved * here.on_other).norm(), 1e-6) << i;
  }
}

// The smallest over bodies is that of each alone; of two the same the first is named.
TEST(BodyDistance, OfManyBodiesIsThatOfTheClosest) {
  Chance chance(4);
  for (int i = 0; i < 20; ++i) {
    std::vector<RoundedHull> bodies;
    for (int k = 0; k < 12; ++k) {
      bodies.push_back(test::randomBody(chance, 15, 0.02, 0.002, {0.01 * k, 0.0, 0.0}));
    }
    const DistancePart part(soup(chance, 100, 0.01, chance.inBox(0.05), 0.03));
    std::vector<const RoundedHull*> all;
    double smallest = std::numeric_limits<double>::infinity();
    for (const RoundedHull& body : bodies) {
      all.push_back(&body);
      smallest = std::min(smallest, distance({&body}, part, Pose())->distance);
    }
    const std::size_t count = all.size();
    for (std::size_t k = 0; k < count; ++k) all.push_back(all[k]);
    const auto pair = distance(all, part, Pose());
    EXPECT_NEAR(pair->distance, smallest, 1e-12);
    EXPECT_LT(pair->body, count);
  }
  EXPECT_FALSE(distance(std::vector<const RoundedHull*>(), DistancePart(boxMesh({1, 1, 1})), Pose()));
}

TEST(BodyDistance, EnteringTrianglesAreThoseWithinTheBody) {
  Chance chance(5);
  std::size_t total = 0;
  for (int i = 0; i < 6; ++i) {
    const RoundedHull first = test::randomBody(chance, 12, 0.03, 0.003),
                      second = test::randomBody(chance, 8, 0.02, 0.002, chance.inBox(0.02));
    const TriangleMesh mesh = soup(chance, 40, 0.006, Vector3d::Zero(), 0.015);
    std::vector<std::uint32_t> expected;
    for (std::uint32_t k = 0; k < mesh.triangles.size(); ++k) {
      const Corners corners = test::cornersOf(mesh, k);
      if (test::bodyDistance(first, corners) <= 0 || test::bodyDistance(second, corners) <= 0) {
        expected.push_back(k);
      }
    }
    total += expected.size();
    EXPECT_EQ(enteringTriangles({&first, &second}, DistancePart(mesh), Pose()), expected) << i;
  }
  EXPECT_GT(total, 50u);
  EXPECT_LT(total, 200u);  // of 240
}

TEST(BodyDistance, RefusesAPoseThatIsNotFinite) {
  const RoundedHull body = test::boxBody({0.01, 0.01, 0.01}, 0.001);
  const DistancePart part(boxMesh({1, 1, 1}));
  Pose pose;
  pose.position.x() = std::nan("");
  EXPECT_THROW(distance({&body}, part, pose), std::invalid_argument);
  EXPECT_THROW(enteringTriangles({&body}, part, pose), std::invalid_argument);
}

// Per axis the nearest the second box comes to the middle of the first, minus half the first: a box's height
// is the largest of these.
TEST(CoupleDistance, OfBoxes) {
  Chance chance(6);
  int deep = 0;
  for (int i = 0; i < 200; ++i) {
    const Vector3d size = Vector3d::Constant(0.011) + chance.inBox(0.01),
                   other = Vector3d::Constant(0.011) + chance.inBox(0.01), at = chance.inBox(0.02);
    const RoundedHull first = test::boxBody(size, 0.001), second = test::boxBody(other, 0.002, at);
    const Eigen::Array3d gap = at.array().abs() - 0.5 * (size + other).array();
    double expected = gap.max(0.0).matrix().norm();
    if (expected == 0.0) {
      const auto entered = [&](const Vector3d& of, const Vector3d& by) {
        return ((at.array().abs() - 0.5 * by.array()).max(0.0) - 0.5 * of.array()).maxCoeff();
      };
      expected = std::min(entered(size, other), entered(other, size));
      ++deep;
    }
    const BodyPair pair = distance({{&first, &second}}).value();
    EXPECT_NEAR(pair.distance, expected - 0.003, 1e-12) << i;
    EXPECT_NEAR((pair.on_body - pair.on_other).norm(), std::abs(pair.distance), 1e-12) << i;
  }
  EXPECT_GT(deep, 20);
}

// The smallest height of a tetrahedron's points over another one is where four of the eight planes decide:
// all combinations tried.
TEST(CoupleDistance, DepthOfTetrahedraAgreesWithAllCombinationsOfPlanes) {
  Chance chance(7);
  int deep = 0;
  for (int i = 0; i < 200; ++i) {
    const RoundedHull of = test::randomBody(chance, 4, 0.03, 0.0),
                      by = test::randomBody(chance, 4, 0.03, 0.0);
    Eigen::Matrix<double, 8, 5> rows;  // n·x - t <= d; n·x <= d
    rows.setZero();
    for (Eigen::Index k = 0; k < 4; ++k) {
      rows.row(k) << of.core.planes().col(k).head<3>().transpose(), -1.0, of.core.planes()(3, k);
      rows.row(k + 4) << by.core.planes().col(k).head<3>().transpose(), 0.0, by.core.planes()(3, k);
    }
    double expected = std::numeric_limits<double>::infinity();
    for (int mask = 0; mask < 256; ++mask) {
      Eigen::Matrix<double, 4, 5> chosen;
      Eigen::Index count = 0;
      for (int k = 0; k < 8; ++k) {
        if (!(mask >> k & 1)) continue;
        if (count < 4) chosen.row(count) = rows.row(k);
        ++count;
      }
      if (count != 4 || std::abs(chosen.leftCols<4>().determinant()) < 1e-9) continue;
      const Eigen::Vector4d x = chosen.leftCols<4>().fullPivLu().solve(chosen.col(4));
      if ((rows.leftCols<4>() * x - rows.col(4)).maxCoeff() < 1e-11) expected = std::min(expected, x[3]);
    }
    const PlacedBody first(of, Pose()), second(by, Pose());
    const PlacedBody::Height found = first.lowest(second);
    EXPECT_NEAR(found.height, expected, 1e-10) << i;
    EXPECT_LT(second.height(found.point).height, 1e-12) << i;
    deep += expected < 0.0;
  }
  EXPECT_GT(deep, 20);
}

TEST(CoupleDistance, OfRandomBodiesAgreesWithBruteForce) {
  Chance chance(8);
  int clear = 0;
  for (int i = 0; i < 25; ++i) {
    const RoundedHull first = test::randomBody(chance, 10, 0.03, 0.003),
                      second = test::randomBody(chance, 10, 0.03, 0.002, chance.inBox(0.03));
    const PlacedBody a(first, Pose()), b(second, Pose());
    if (a.lowest(b).height < 0.0) continue;
    test::Real expected = std::numeric_limits<test::Real>::infinity();
    for (std::size_t k = 0; k < second.core.surface().triangles.size(); ++k) {
      expected = std::min(expected, test::bodyDistance(first, test::cornersOf(second.core.surface(), k)));
    }
    EXPECT_NEAR(distance({{&first, &second}})->distance, static_cast<double>(expected) - 0.002, kExact) << i;
    ++clear;
  }
  EXPECT_GT(clear, 5);
}

}  // namespace
}  // namespace cable_variation
