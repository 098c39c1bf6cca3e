// Distances of cables to parts in closed form: clear, overlapping, pierced, inside; which way they change;
// where else they are as small; stretches that do not count.
#include <cable_variation/geometry/tube_distance/distance.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include <gtest/gtest.h>

#include <cable_variation/geometry/tube_distance/part_vicinity.h>
#include <cable_variation/geometry/body/primitives.h>
#include <cable_variation/geometry/tube_distance/tube.h>
#include <cable_variation/math/so3.h>
#include <geometry/distance_oracle.h>

namespace cable_variation {
namespace {

using Contact = ClosestPair::Contact;
using Eigen::Vector3d;

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kExact = 1e-12;  // closed forms, to rounding [m]

TriangleMesh moved(TriangleMesh mesh, const Vector3d& by) {
  for (Vector3d& vertex : mesh.vertices) vertex += by;
  return mesh;
}

TriangleMesh turnedInsideOut(TriangleMesh mesh) {
  for (auto& triangle : mesh.triangles) std::swap(triangle[0], triangle[1]);
  return mesh;
}

TriangleMesh together(TriangleMesh a, const TriangleMesh& b) {
  const auto first = static_cast<std::uint32_t>(a.vertices.size());
  a.vertices.insert(a.vertices.end(), b.vertices.begin(), b.vertices.end());
  for (const auto& [i, j, k] : b.triangles) a.triangles.push_back({first + i, first + j, first + k});
  return a;
}

/// Every triangle with corners of its own, as in an STL file.
TriangleMesh loose(const TriangleMesh& mesh) {
  TriangleMesh apart;
  for (const auto& triangle : mesh.triangles) {
    const auto first = static_cast<std::uint32_t>(apart.vertices.size());
    for (const std::uint32_t vertex : triangle) apart.vertices.push_back(mesh.vertices[vertex]);
    apart.triangles.push_back({first, first + 1, first + 2});
  }
  return apart;
}

ClosestPair pairOf(const Centreline& cable, const TriangleMesh& mesh,
                   const std::vector<SkippedStretch>& skipped = {}) {
  return distance(cable, DistancePart(mesh), Pose(), skipped).value();
}

/// A cube of 1 m about the origin.
TriangleMesh cube() { return boxMesh({1.0, 1.0, 1.0}); }

TEST(Distance, ToACorner) {
  // the line through (1, 1, 1) * 0.6 normal to the diagonal
  const Vector3d point(0.6, 0.6, 0.6), along = Vector3d(1.0, -1.0, 0.0).normalized();
  const Centreline cable = test::straightCable(point - 0.3 * along, point + 0.4 * along, 0.01, 3);
  const ClosestPair pair = pairOf(cable, cube());
  EXPECT_NEAR(pair.distance, 0.1 * std::sqrt(3.0) - 0.01, kExact);
  EXPECT_EQ(pair.contact, Contact::clear);
  EXPECT_NEAR((pair.on_other - Vector3d(0.5, 0.5, 0.5)).norm(), 0.0, kExact);
  EXPECT_NEAR((pair.on_cable - point).norm(), 0.0, 1e-8);
  EXPECT_NEAR((pair.direction - Vector3d::Ones().normalized()).norm(), 0.0, 1e-7);
  EXPECT_NEAR(cable.arcLength(pair.place), 0.3, 1e-8);
  EXPECT_EQ(pair.runner_up, kInfinity);
}

TEST(Distance, ToAParallelFaceAndEdgeIsNotUnique) {
  const ClosestPair face = pairOf(test::straightCable({-0.3, 0.1, 0.8}, {0.3, 0.1, 0.8}, 0.02, 4), cube());
  EXPECT_NEAR(face.distance, 0.28, kExact);
  EXPECT_NEAR(face.runner_up, 0.28, kExact);
  const ClosestPair edge = pairOf(test::straightCable({-0.3, 0.8, 0.9}, {0.3, 0.8, 0.9}, 0.02, 4), cube());
  EXPECT_NEAR(edge.distance, 0.48, kExact);
  EXPECT_NEAR(edge.runner_up, 0.48, kExact);
}

// Sloping by 1e-4 over a face the end is lowest, alone, however flat.
TEST(Distance, ToASlopingFaceIsUnique) {
  const ClosestPair pair =
      pairOf(test::straightCable({-0.02, 0.1, 0.8}, {0.02, 0.1, 0.800004}, 0.002, 4), cube());
  EXPECT_NEAR(pair.distance, 0.298, kExact);
  EXPECT_EQ(pair.place.piece, 0u);
  EXPECT_EQ(pair.place.t, 0.0);
  EXPECT_EQ(pair.runner_up, kInfinity);
}

TEST(Distance, BetweenTwoFacesIsNotUnique) {
  const TriangleMesh gap = together(cube(), moved(cube(), {0.0, 0.0, 1.1}));
  // straight across, its start midway between two faces; off the middle by 1 µm, and by more than the margin
  const auto cable = [](double off) {
    return test::straightCable({0.0, 0.0, 0.55 + off}, {0.0, 2.0, 0.55 + 30.0 * off}, 0.01, 5);
  };
  const ClosestPair middle = pairOf(cable(0.0), gap);
  EXPECT_NEAR(middle.distance, 0.04, kExact);
  EXPECT_NEAR(middle.runner_up, 0.04, kExact);
  EXPECT_LT(pairOf(cable(1e-6), gap).runner_up, kInfinity);
}

TEST(Distance, InACornerSeesBothWalls) {
  // an L of two faces that share an edge: y = 0 and z = 0
  TriangleMesh walls;
  walls.vertices = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {1, 0, 1}, {0, 0, 1}};
  walls.triangles = {{0, 1, 2}, {0, 2, 3}, {0, 1, 4}, {0, 4, 5}};
  // towards the walls and away again, closest at x = 0.5
  Centreline cable;
  const double length = 0.4;
  const auto end = [&](double x, double slope) {
    return CurvePiece::End{Vector3d(0.5 + x, 0.05 + x * x, 0.05 + x * x), Vector3d(1.0, slope, slope),
                           Vector3d(0.0, 2.0, 2.0)};
  };
  cable.pieces.push_back({CurvePiece(end(-0.2, -0.4), end(0.2, 0.4), length), 0.0, length, 0.01, 0.01});
  const ClosestPair pair = pairOf(cable, walls);
  EXPECT_NEAR(pair.distance, 0.04, 1e-9);
  EXPECT_NEAR(pair.runner_up, 0.04, 1e-9);
  // nearer to one of them by far
  for (Centreline::Piece& piece : cable.pieces) {
    const auto off = [&](double t) {
      return CurvePiece::End{piece.curve.position(t) + Vector3d(0, 0, 0.01), piece.curve.first(t),
                             piece.curve.second(t)};
    };
    piece.curve = CurvePiece(off(0.0), off(1.0), 1.0);
  }
  EXPECT_EQ(pairOf(cable, walls).runner_up, kInfinity);
}

TEST(Distance, OfAnArchComesDownAtBothEnds) {
  Centreline arch;
  const auto end = [](double x) {
    return CurvePiece::End{Vector3d(x, 0.0, 0.62 - x * x), Vector3d(1.0, 0.0, -2.0 * x),
                           Vector3d(0.0, 0.0, -2.0)};
  };
  arch.pieces.push_back({CurvePiece(end(-0.1), end(0.1), 0.2), 0.0, 0.2, 0.01, 0.01});
  const ClosestPair pair = pairOf(arch, cube());
  EXPECT_NEAR(pair.distance, 0.1, kExact);
  EXPECT_NEAR(pair.runner_up, 0.1, kExact);
}

TEST(Distance, IsNegativeWhereTheSurfaceEnters) {
  const ClosestPair pair =
      pairOf(test::straightCable({0.0, -1.0, 0.503}, {0.0, 1.0, 0.503}, 0.01, 6), cube());
  EXPECT_NEAR(pair.distance, -0.007, kExact);
  EXPECT_EQ(pair.contact, Contact::overlap);
  EXPECT_NEAR((pair.direction - Vector3d::UnitZ()).norm(), 0.0, kExact);
}

TEST(Distance, OfATaperedCableCountsTheRadiusThere) {
  Centreline cable = test::straightCable({-0.3, 0.0, 0.6}, {0.3, 0.0, 0.6}, 0.01);
  cable.pieces[0].end_radius = 0.03;
  const ClosestPair pair = pairOf(cable, cube());
  EXPECT_NEAR(pair.distance, 0.07, kExact);
  EXPECT_NEAR(pair.place.t, 1.0, kExact);
}

TEST(Distance, InsideIsMinusTheDepthAndTheRadius) {
  // 100 mm below a face at its deepest: a line that dips, x = ±0.2, deepest in the middle
  for (const TriangleMesh& mesh :
       {cube(), loose(cube()), turnedInsideOut(cube()), together(cube(), turnedInsideOut(cube()))}) {
    const ClosestPair pair = pairOf(test::straightCable({0.4, -0.1, 0.0}, {0.45, 0.1, 0.0}, 0.01, 5), mesh);
    EXPECT_EQ(pair.contact, Contact::pierced);
    EXPECT_NEAR(pair.distance, -0.11, 1e-9);
    EXPECT_NEAR((pair.on_cable - Vector3d(0.4, -0.1, 0.0)).norm(), 0.0, 1e-9);
    EXPECT_NEAR((pair.on_other - Vector3d(0.5, -0.1, 0.0)).norm(), 0.0, 1e-9);
    EXPECT_NEAR((pair.direction - Vector3d::UnitX()).norm(), 0.0, 1e-9);
    EXPECT_EQ(pair.runner_up, kInfinity);
  }
}

TEST(Distance, InTheMiddleOfABoxSeesAllItsFaces) {
  const ClosestPair pair = pairOf(test::straightCable({0.0, 0.0, -2.0}, {0.0, 0.0, 2.0}, 0.01, 9), cube());
  EXPECT_EQ(pair.contact, Contact::pierced);
  EXPECT_NEAR(pair.distance, -0.51, 1e-8);
  EXPECT_NEAR(pair.runner_up, -0.51, 1e-8);
}

TEST(Distance, ThroughAPlateIsHalfItsThickness) {
  const ClosestPair pair =
      pairOf(test::straightCable({0.01, 0.02, -0.1}, {0.01, 0.02, 0.15}, 0.01, 9), boxMesh({1.0, 1.0, 0.03}));
  EXPECT_EQ(pair.contact, Contact::pierced);
  EXPECT_NEAR(pair.distance, -0.025, 1e-8);
  EXPECT_NEAR(pair.runner_up, -0.025, 1e-8);  // both faces are as near
}

TEST(Distance, IntoABlindHoleOfDepthIsThatDepth) {
  // the end is 30 mm below the top face
  const ClosestPair pair = pairOf(test::straightCable({0.1, 0.0, 0.47}, {0.1, 0.0, 0.8}, 0.01, 4), cube());
  EXPECT_EQ(pair.contact, Contact::pierced);
  EXPECT_NEAR(pair.distance, -0.04, 1e-9);
  EXPECT_EQ(pair.place.piece, 0u);
  EXPECT_NEAR(pair.place.t, 0.0, 1e-9);
}

TEST(Distance, ThroughAnOpenSurfaceIsMinusTheRadius) {
  TriangleMesh lid = cube();  // its two facets at z = 0.5
  lid.triangles.erase(std::remove_if(lid.triangles.begin(), lid.triangles.end(),
                                     [&](const auto& facet) {
                                       return std::any_of(facet.begin(), facet.end(), [&](std::uint32_t i) {
                                         return lid.vertices[i].z() < 0.0;
                                       });
                                     }),
                      lid.triangles.end());
  ASSERT_EQ(lid.triangles.size(), 2U);
  EXPECT_EQ(DistancePart(lid).openness().edges, 4U);
  EXPECT_NEAR(DistancePart(lid).openness().length, 4.0, kExact);
  const ClosestPair through = pairOf(test::straightCable({0.1, 0.0, 0.3}, {0.1, 0.0, 0.8}, 0.01, 4), lid);
  EXPECT_EQ(through.contact, Contact::pierced);
  EXPECT_FALSE(through.is_depth);
  EXPECT_NEAR(through.distance, -0.01, kExact);
  EXPECT_NEAR((through.direction - Vector3d::UnitZ()).cross(through.direction + Vector3d::UnitZ()).norm(),
              0.0,
              kExact);  // one normal or the other
  // far from it the winding number is clear: outside; 1 / 12 before a face of a cube as high as wide
  const ClosestPair before = pairOf(test::straightCable({0.0, 0.0, 1.5}, {0.0, 0.0, 2.5}, 0.01, 4), lid);
  EXPECT_EQ(before.side, ClosestPair::Side::wound);
  EXPECT_NEAR(before.distance, 0.99, kExact);
  // half a side away it is a sixth, not clear
  const ClosestPair beside = pairOf(test::straightCable({0.0, 0.0, 0.0}, {0.0, 0.0, -1.0}, 0.01, 4), lid);
  EXPECT_EQ(beside.side, ClosestPair::Side::undecided);
  EXPECT_NEAR(std::abs(beside.winding), 1.0 / 6.0, 1e-9);
  EXPECT_NEAR(beside.distance, 0.49, kExact);
}

// A cube of which facets are missing is inside where its winding number is clear.
TEST(Distance, InAnOpenCubeIsInsideWhereThatIsClear) {
  TriangleMesh open = cube();
  open.triangles.pop_back();
  const ClosestPair within = pairOf(test::straightCable({0.0, 0.0, 0.0}, {0.1, 0.05, 0.02}, 0.01), open);
  EXPECT_EQ(within.side, ClosestPair::Side::wound);
  EXPECT_NEAR(std::abs(within.winding), 11.0 / 12.0, 0.02);
  EXPECT_TRUE(within.is_depth);
  EXPECT_NEAR(within.distance, -0.51, 1e-8);
  // without a whole face 5/6 in the middle: not clear, the value is the distance to what is there
  TriangleMesh tray = cube();
  tray.triangles.erase(std::remove_if(tray.triangles.begin(), tray.triangles.end(),
                                      [&](const auto& facet) {
                                        return std::all_of(facet.begin(), facet.end(), [&](std::uint32_t i) {
                                          return tray.vertices[i].z() > 0.0;
                                        });
                                      }),
                       tray.triangles.end());
  ASSERT_EQ(tray.triangles.size(), 10U);
  const ClosestPair in_tray = pairOf(test::straightCable({0.0, 0.0, 0.0}, {0.0, 0.0, 1.0}, 0.01), tray);
  EXPECT_EQ(in_tray.side, ClosestPair::Side::undecided);
  EXPECT_NEAR(in_tray.winding, 5.0 / 6.0, 0.01);
  EXPECT_FALSE(in_tray.is_depth);
  EXPECT_NEAR(in_tray.distance, 0.49, kExact);
}

// Edges and corners right in the way, where a ray or a plane test may slip through.
TEST(Distance, ThroughAnEdgeAndACornerIsPierced) {
  for (const Vector3d& at : {Vector3d(0.5, 0.5, 0.5), Vector3d(0.5, 0.5, 0.1), Vector3d(0.5, 0.0, 0.0)}) {
    const Vector3d along = at.normalized();
    const ClosestPair pair = pairOf(test::straightCable(at - 0.05 * along, at + 0.05 * along, 0.01), cube());
    EXPECT_EQ(pair.contact, Contact::pierced);
    EXPECT_LT(pair.distance, -0.03);
  }
}

// A sphere of chords: the cable's middle is nearest to a facet, whose distance from the centre is what it is.
// A cable that lies on a table by its centreline: nothing of it is inside, nor just outside.
TEST(Distance, AlongAFaceIsMinusTheRadius) {
  for (const double end : {0.3, 0.7}) {
    const ClosestPair pair = pairOf(test::straightCable({-0.3, 0.1, 0.5}, {end, 0.1, 0.5}, 0.02, 7), cube());
    EXPECT_EQ(pair.contact, Contact::pierced);
    EXPECT_NEAR(pair.distance, -0.02, 2e-9);  // depths of less than 1e-9 m are not told from none
  }
}

TEST(Distance, InASphereIsTheSmallestOfItsFacets) {
  const TriangleMesh sphere = moved(sphereMesh(0.2), {0.03, 0.02, 0.01});
  const Centreline cable = test::straightCable({-0.02, 0.0, 0.0}, {0.02, 0.01, 0.0}, 0.004, 3);
  const ClosestPair pair = pairOf(cable, sphere);
  EXPECT_EQ(pair.contact, Contact::pierced);
  // by brute force: the largest over the cable of the smallest over the triangles
  double deepest = 0.0;
  for (std::size_t piece = 0; piece < 3; ++piece) {
    for (int i = 0; i <= 200; ++i) {
      const Vector3d x = cable.position({piece, i / 200.0});
      test::Real depth = 1.0L;
      for (const auto& [a, b, c] : sphere.triangles) {
        depth = std::min(depth, test::triangleDistance({sphere.vertices[a].cast<test::Real>(),
                                                        sphere.vertices[b].cast<test::Real>(),
                                                        sphere.vertices[c].cast<test::Real>()},
                                                       x.cast<test::Real>()));
      }
      deepest = std::max(deepest, static_cast<double>(depth));
    }
  }
  // a step of the samples is 42 mm / 600 = 70 µm, and depth changes by at most half of it to the next sample
  EXPECT_GE(-pair.distance - 0.004, deepest - kExact);
  EXPECT_LE(-pair.distance - 0.004, deepest + 3.5e-5);
}

TEST(Distance, InACavityIsToItsWall) {
  // a hollow cube, 100 mm thick
  const TriangleMesh hollow = together(cube(), turnedInsideOut(boxMesh({0.8, 0.8, 0.8})));
  const ClosestPair within = pairOf(test::straightCable({0.0, 0.0, 0.1}, {0.1, 0.0, 0.2}, 0.01, 3), hollow);
  EXPECT_EQ(within.contact, Contact::clear);
  EXPECT_NEAR(within.distance, 0.19, kExact);
  // in the wall, 20 mm from the cavity and 80 mm from outside
  const ClosestPair wall = pairOf(test::straightCable({0.0, 0.0, 0.42}, {0.05, 0.0, 0.415}, 0.01, 3), hollow);
  EXPECT_EQ(wall.contact, Contact::pierced);
  EXPECT_NEAR(wall.distance, -0.03, 1e-9);
}

TEST(Distance, InOverlappingSolidsIsInside) {
  const TriangleMesh both = together(cube(), moved(cube(), {0.7, 0.0, 0.0}));
  const ClosestPair pair = pairOf(test::straightCable({0.35, 0.0, 0.0}, {0.36, 0.0, 0.0}, 0.01), both);
  EXPECT_EQ(pair.contact, Contact::pierced);
  EXPECT_NEAR(pair.distance, -0.17, 1e-9);
  // solids that share a face, with the same corners
  const TriangleMesh stacked = together(cube(), moved(cube(), {1.0, 0.0, 0.0}));
  EXPECT_EQ(pairOf(test::straightCable({0.2, 0.0, 0.0}, {0.3, 0.0, 0.0}, 0.01), stacked).contact,
            Contact::pierced);
}

TEST(Distance, SkipsWhatDoesNotCount) {
  // up from inside the cube, through its top
  const Centreline cable = test::straightCable({0.1, 0.1, 0.3}, {0.1, 0.1, 0.9}, 0.01, 7);
  const ClosestPair above = pairOf(cable, cube(), {{0.0, 0.25}});
  EXPECT_EQ(above.contact, Contact::clear);
  EXPECT_NEAR(above.distance, 0.04, kExact);
  EXPECT_NEAR(cable.arcLength(above.place), 0.25, kExact);
  // what is left inside is inside, though nothing pierces
  const ClosestPair below = pairOf(cable, cube(), {{0.1, 0.25}});
  EXPECT_EQ(below.contact, Contact::pierced);
  EXPECT_NEAR(below.distance, -0.21, 1e-9);
  EXPECT_FALSE(distance(cable, DistancePart(cube()), Pose(), {{-1.0, 0.3}, {0.3, 2.0}}));
}

// The whole cable moves: the distance changes by direction · motion, against central differences.
TEST(Distance, ChangesAlongItsDirection) {
  test::Chance chance(3);
  const TriangleMesh mesh = cylinderMesh(0.05, 0.2);
  const DistancePart part(mesh);
  int checked = 0;
  for (int i = 0; i < 300; ++i) {
    const Centreline cable = test::randomCable(chance, 3, 0.04, 0.5, 0.005, chance.oneOf(2));
    Pose pose{chance.inBox(0.15), chance.orientation()};
    const auto pair = distance(cable, part, pose);
    ASSERT_TRUE(pair);
    if (pair->runner_up < kInfinity || pair->contact == Contact::pierced) continue;
    // of the part, about a point of its own: v = translation + rotation × (x - position)
    const Vector3d translation = chance.direction(), rotation = 10.0 * chance.direction();
    const Vector3d moves = translation + rotation.cross(pair->on_other - pose.position);
    const auto at = [&](double h) {
      return distance(cable, part,
                      {pose.position + h * translation, so3::exp(h * rotation) * pose.orientation})
          ->distance;
    };
    constexpr double h = 1e-6;
    const double rate = (at(h) - at(-h)) / (2.0 * h), expected = -pair->direction.dot(moves);
    // rounding 1e-16 / h, and h² times third derivatives, up to 1 / (2 mm)²
    EXPECT_NEAR(rate, expected, 1e-6 * moves.norm()) << i << ", distance " << pair->distance;
    ++checked;
  }
  EXPECT_GT(checked, 150);
}

TEST(Distance, InsideChangesAlongItsDirectionToo) {
  const DistancePart part(cube());
  const Centreline cable = test::straightCable({0.4, -0.1, 0.0}, {0.45, 0.1, 0.03}, 0.01, 5);
  const auto pair = distance(cable, part, Pose());
  ASSERT_TRUE(pair);
  const Vector3d move(0.3, -0.2, 0.7);
  constexpr double h = 1e-6;
  const double rate = (distance(cable, part, {h * move, Eigen::Quaterniond::Identity()})->distance -
                       distance(cable, part, {-h * move, Eigen::Quaterniond::Identity()})->distance) /
                      (2.0 * h);
  EXPECT_NEAR(rate, -pair->direction.dot(move), 1e-6);
}

TEST(Distance, IsTheSameWithAHint) {
  test::Chance chance(4);
  const DistancePart part(cylinderMesh(0.05, 0.2));
  ClosestPair hint;
  hint.place = {99, 0.5};
  hint.triangle = 1u << 30;  // of something else
  for (int i = 0; i < 200; ++i) {
    const Centreline cable = test::randomCable(chance, 5, 0.04, 0.5, 0.005, false);
    const Pose pose{chance.inBox(0.2), chance.orientation()};
    const auto cold = distance(cable, part, pose), warm = distance(cable, part, pose, {}, 1e-5, {&hint});
    ASSERT_TRUE(cold && warm);
    EXPECT_NEAR(cold->distance, warm->distance, 1e-9) << i;
    EXPECT_EQ(cold->contact, warm->contact) << i;
    hint = *cold;
  }
}

// A cable about its own shape, a part about its own pose: whatever of the part was thought to be enough, what
// is found is the same, and a limit hides nothing below it.
TEST(Distance, IsTheSameInAVicinity) {
  test::Chance chance(5);
  const DistancePart part(together(cylinderMesh(0.05, 0.2), moved(cube(), {0.6, 0.0, 0.0})));
  int enough = 0, limited = 0;
  for (int i = 0; i < 100; ++i) {
    const Centreline cable = test::randomCable(chance, 5, 0.04, 0.5, 0.005, false);
    const Pose pose{chance.inBox(0.2), chance.orientation()};
    const double reach = std::max(distance(cable, part, pose)->distance, 0.0) + 0.01;
    const PartVicinity vicinity(cable, part, pose, reach);
    for (int k = 0; k < 5; ++k) {
      const Pose near{pose.position + 0.005 * chance.direction(),
                      so3::exp(0.02 * chance.direction()) * pose.orientation};
      const auto whole = distance(cable, part, near);
      ASSERT_TRUE(whole);
      const ClosestPair hint = *distance(cable, part, pose);
      const auto within = distance(cable, part, near, {}, 1e-5, {&hint, &vicinity});
      ASSERT_TRUE(within);
      EXPECT_NEAR(whole->distance, within->distance, 1e-9) << i;
      EXPECT_EQ(whole->contact, within->contact) << i;
      EXPECT_NEAR((whole->on_other - within->on_other).norm(), 0.0, 1e-6) << i;
      enough += vicinity.completeWithin(cable, near) > whole->distance ? 1 : 0;
      for (const double share : {-0.002, 0.002}) {
        const double limit = whole->distance + share;
        const auto below = distance(cable, part, near, {}, 1e-5, {nullptr, &vicinity, limit});
        if (share > 0.0) {
          ASSERT_TRUE(below) << i;
        }
        limited += below ? 0 : 1;
        if (below) {
          EXPECT_NEAR(below->distance, whole->distance, 1e-9) << i;
        }
      }
    }
  }
  EXPECT_GT(enough, 300);
  EXPECT_GT(limited, 300);
}

TEST(Distance, RefusesWhatItCannotMeasure) {
  EXPECT_THROW(DistancePart{TriangleMesh()}, std::invalid_argument);
  TriangleMesh bad = cube();
  bad.triangles[3][1] = 8;
  EXPECT_THROW(DistancePart{bad}, std::invalid_argument);
  bad = cube();
  bad.vertices[2].y() = std::nan("");
  EXPECT_THROW(DistancePart{bad}, std::invalid_argument);
  const DistancePart part(cube());
  const Centreline cable = test::straightCable({0.0, 0.0, 1.0}, {1.0, 0.0, 1.0}, 0.01);
  EXPECT_THROW(distance(Centreline(), part, Pose()), std::invalid_argument);
  EXPECT_THROW(distance(cable, part, Pose{{kInfinity, 0.0, 0.0}, Eigen::Quaterniond::Identity()}),
               std::invalid_argument);
  EXPECT_THROW(distance(cable, part, Pose(), {{0.2, 0.1}}), std::invalid_argument);
  EXPECT_THROW(distance(cable, part, Pose(), {}, std::nan("")), std::invalid_argument);
  Centreline backwards = cable;
  backwards.pieces[0].end = -1.0;
  EXPECT_THROW(distance(backwards, part, Pose()), std::invalid_argument);
}

}  // namespace
}  // namespace cable_variation
