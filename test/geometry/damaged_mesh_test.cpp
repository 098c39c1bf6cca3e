// Shells as exporters write them: what is damaged and means the same solid has the same inside and depth;
// what is open says so, and tells inside from outside where its winding number does.
#include <cable_variation/geometry/tube_distance/distance.h>

#include <cmath>

#include <gtest/gtest.h>

#include <cable_variation/geometry/body/body_distance.h>
#include <cable_variation/geometry/mesh/welded_surface.h>
#include <geometry/damaged_shells.h>
#include <geometry/distance_oracle.h>

namespace cable_variation {
namespace {

using Contact = ClosestPair::Contact;
using Side = ClosestPair::Side;
using Eigen::Vector3d;
using test::Chance;
using test::LooseFacets;

// About a shell, through it or within.
Centreline cableAbout(Chance& chance, const TriangleMesh& shell) {
  const double size = test::diagonal(shell);
  Vector3d middle = Vector3d::Zero();
  for (const Vector3d& vertex : shell.vertices) middle += vertex / static_cast<double>(shell.vertices.size());
  const Vector3d from = middle + chance.inBox(0.35 * size);
  return test::straightCable(from, from + chance.between(0.02, 0.6) * size * chance.direction(),
                             chance.size(1e-4, 0.05) * size, 1 + chance.below(4));
}

double lowestSide(const Centreline& cable, const ClosestPair& pair) {
  return pair.distance + cable.radius(pair.place);
}

struct Damage {
  const char* name;
  void (*apply)(Chance&, LooseFacets&, double size);
  double moved;  // vertices, at most, of the size
};
const Damage kDamages[] = {
    {"corners of their own", [](Chance&, LooseFacets&, double) {}, 0.0},
    {"jitter of doubles",
     [](Chance& chance, LooseFacets& facets, double size) { facets.jitter(chance, 1e-16 * size); }, 2e-16},
    {"jitter of 1e-9",
     [](Chance& chance, LooseFacets& facets, double size) { facets.jitter(chance, 1e-9 * size); }, 2e-9},
    {"single precision", [](Chance& chance, LooseFacets& facets, double) { facets.jitter(chance, 0.0); },
     2e-6},
    {"slivers",
     [](Chance& chance, LooseFacets& facets, double) {
       for (std::size_t i = 1 + chance.below(5); i > 0; --i) facets.addSliver(chance);
     },
     0.0},
    {"doubled facets",
     [](Chance& chance, LooseFacets& facets, double) {
       for (std::size_t i = 1 + chance.below(5); i > 0; --i) facets.doubleOne(chance);
     },
     0.0},
    {"T-junctions",
     [](Chance& chance, LooseFacets& facets, double) {
       for (std::size_t i = 1 + chance.below(5); i > 0; --i) facets.divideOne(chance);
     },
     2e-16},
    {"flipped facets",
     [](Chance& chance, LooseFacets& facets, double) {
       for (std::size_t i = 1 + chance.below(3); i > 0; --i) facets.flipOne(chance);
     },
     0.0},
    {"all of these",
     [](Chance& chance, LooseFacets& facets, double size) {
       for (std::size_t i = 1 + chance.below(4); i > 0; --i) facets.divideOne(chance);
       for (std::size_t i = 1 + chance.below(4); i > 0; --i) facets.flipOne(chance);
       for (std::size_t i = 1 + chance.below(4); i > 0; --i) facets.addSliver(chance);
       for (std::size_t i = 1 + chance.below(4); i > 0; --i) facets.doubleOne(chance);
       facets.jitter(chance, 1e-10 * size);
     },
     2e-10}};

TEST(DamagedMesh, HasTheDistanceAndDepthOfTheWholeOne) {
  Chance chance(11);
  int inside = 0;
  for (int i = 0; i < 630; ++i) {
    const TriangleMesh shell = test::randomShell(chance);
    const double size = test::diagonal(shell);
    const Damage& damage = kDamages[static_cast<std::size_t>(i) % std::size(kDamages)];
    LooseFacets facets(shell);
    damage.apply(chance, facets, size);
    facets.shuffle(chance);
    const DistancePart whole(shell), damaged(facets.mesh());
    EXPECT_FALSE(whole.openness().isOpen());
    EXPECT_FALSE(damaged.openness().isOpen())
        << i << " " << damage.name << ": " << damaged.openness().edges << " of " << facets.facets.size();
    for (int k = 0; k < 4; ++k) {
      const Centreline cable = cableAbout(chance, shell);
      const auto expected = distance(cable, whole, Pose()), found = distance(cable, damaged, Pose());
      ASSERT_TRUE(expected && found);
      EXPECT_NEAR(found->distance, expected->distance, 4e-9 + 2.0 * damage.moved * size)
          << i << " " << damage.name;
      const double side = lowestSide(cable, *expected);
      if (std::abs(side) > 1e-5 * size) {
        EXPECT_EQ(found->contact, expected->contact) << i << " " << damage.name;
      }
      EXPECT_EQ(found->side, Side::known);
      inside += side < 0.0;
    }
  }
  EXPECT_GT(inside, 400);
}

// A hollow solid: cavities need to know which way shells face.
TEST(DamagedMesh, KeepsItsCavity) {
  Chance chance(12);
  for (int i = 0; i < 200; ++i) {
    const TriangleMesh cavity = test::refined(boxMesh({0.8, 0.8, 0.8}));
    TriangleMesh shell = test::refined(boxMesh({1.0, 1.0, 1.0}));
    const auto first = static_cast<std::uint32_t>(shell.vertices.size());
    shell.vertices.insert(shell.vertices.end(), cavity.vertices.begin(), cavity.vertices.end());
    for (const auto& [a, b, c] : cavity.triangles)
      shell.triangles.push_back({first + a, first + c, first + b});
    LooseFacets facets(shell);
    kDamages[static_cast<std::size_t>(i) % std::size(kDamages)].apply(chance, facets, 1.7);
    facets.shuffle(chance);
    const DistancePart part(facets.mesh());
    const auto within = distance(test::straightCable({0.0, 0.0, 0.1}, {0.1, 0.0, 0.2}, 0.01), part, Pose());
    EXPECT_NEAR(within->distance, 0.19, 1e-6) << i;
    const auto wall = distance(test::straightCable({0.0, 0.0, 0.42}, {0.05, 0.0, 0.415}, 0.01), part, Pose());
    EXPECT_NEAR(wall->distance, -0.03, 1e-6) << i;
  }
}

// A patch that stands off by a little, as where faces are meshed one by one: closed, and right to the gap.
TEST(DamagedMesh, SmallCracksAreClosed) {
  Chance chance(13);
  for (int i = 0; i < 200; ++i) {
    const TriangleMesh shell = test::randomShell(chance);
    const double size = test::diagonal(shell), gap = chance.between(0.1, 0.8) * WeldedSurface::kCrack * size;
    LooseFacets facets(shell);
    for (std::size_t k = 1 + chance.below(3); k > 0; --k) {
      const Vector3d by = gap / 4.0 * chance.direction();  // three times at most
      for (Vector3d& corner : facets.facets[chance.below(facets.facets.size())]) corner += by;
    }
    const DistancePart whole(shell), cracked(facets.mesh());
    EXPECT_FALSE(cracked.openness().isOpen()) << i;
    for (int k = 0; k < 4; ++k) {
      const Centreline cable = cableAbout(chance, shell);
      const auto expected = distance(cable, whole, Pose()), found = distance(cable, cracked, Pose());
      if (std::abs(lowestSide(cable, *expected)) < 2.0 * gap) continue;
      EXPECT_NEAR(found->distance, expected->distance, 1e-9 + 2.0 * gap) << i;
      EXPECT_EQ(found->contact, expected->contact) << i;
    }
  }
}

// Facets are missing: the part says that it is open, the winding number is the true one, and where it is
// clear depth and distance are those of the whole one wherever the hole does not matter.
TEST(DamagedMesh, WithAHoleIsOpenAndWound) {
  Chance chance(14);
  int inside = 0, outside = 0, undecided = 0;
  for (int i = 0; i < 400; ++i) {
    const TriangleMesh shell = test::randomShell(chance);
    const double size = test::diagonal(shell);
    LooseFacets facets(shell);
    const std::size_t holes = 1 + chance.below(3);
    for (std::size_t k = 0; k < holes; ++k) {
      facets.facets.erase(facets.facets.begin() +
                          static_cast<std::ptrdiff_t>(chance.below(facets.facets.size())));
    }
    const TriangleMesh oriented = facets.mesh();
    for (std::size_t k = chance.below(3); k > 0 && facets.facets.size() > 20; --k) facets.flipOne(chance);
    if (chance.oneOf(2)) facets.jitter(chance, 1e-12 * size);
    facets.shuffle(chance);
    const DistancePart whole(shell), open(facets.mesh());
    EXPECT_TRUE(open.openness().isOpen()) << i;
    EXPECT_LE(open.openness().edges, 3 * holes) << i;
    EXPECT_GE(open.openness().edges, 3U) << i;
    for (int k = 0; k < 4; ++k) {
      const Centreline cable = cableAbout(chance, shell);
      const auto expected = distance(cable, whole, Pose()), found = distance(cable, open, Pose());
      ASSERT_TRUE(expected && found);
      ASSERT_NE(found->side, Side::known) << i;
      if (found->side == Side::undecided) {
        ++undecided;
        EXPECT_FALSE(found->is_depth) << i;
        continue;
      }
      const bool deep = found->is_depth;
      if (!deep) {
        const double winding = test::oracleWinding(oriented, found->on_cable);
        EXPECT_NEAR(std::abs(found->winding), std::abs(winding), 1e-6) << i;
      }
      const double whole_number = std::round(found->winding);
      EXPECT_LE(std::abs(found->winding - whole_number), kClearWinding) << i;
      EXPECT_EQ(deep, whole_number != 0.0) << i;
      if (deep) {
        ++inside;
        EXPECT_TRUE(expected->is_depth) << i;
        // caps of one facet are that facet; of several beside each other they may bulge or dent
        if (holes == 1) {
          EXPECT_NEAR(found->distance, expected->distance, 1e-8) << i;
        }
      } else {
        ++outside;
        EXPECT_GE(found->distance, expected->distance - 1e-8) << i;
      }
    }
  }
  EXPECT_GT(inside, 200);
  EXPECT_GT(outside, 100);
  std::cout << inside << " inside, " << outside << " outside, " << undecided << " undecided\n";
}

}  // namespace
}  // namespace cable_variation
