#include <cable_variation/envelope/forbidden_region.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include <gtest/gtest.h>

#include <cable_variation/geometry/body/primitives.h>
#include <cable_variation/util/error.h>
#include <geometry/body_oracle.h>
#include <measures/solved_scene.h>

namespace cable_variation {
namespace {

using Eigen::Vector3d;
using test::Chance;

// Numbers with all their digits, a name that no line of a file can hold, bodies that were flat.
ForbiddenRegion randomRegion() {
  Chance chance(1);
  ForbiddenRegion region;
  region.frame = "engine bay";
  region.inflation = 1e-4 / 3.0;
  region.shapes = 2000;
  region.protrusion = 1e-5 / 7.0;
  for (int i = 0; i < 6; ++i) {
    const double start = chance.between(0.0, 0.3), from = chance.between(0.0, 2.0);
    region.pieces.push_back({i % 2 == 0 ? "main" : "a;b=%\n../\xc3\xa4", start, start + 0.008, from,
                             from + chance.size(1e-9, 1.0), static_cast<std::size_t>(i / 3),
                             test::randomBody(chance, 30, 0.02, chance.size(1e-3, 1e-2), chance.inBox(1.0))});
  }
  std::vector<Vector3d> flat;
  for (int i = 0; i < 12; ++i) flat.push_back({chance.between(0, 0.01), chance.between(0, 0.01), 0.2});
  region.pieces.push_back({"main", 0.0, 0.01, 0.0, 0.0, 0, {ConvexHull(flat), 0.004}});
  return region;
}

std::vector<std::array<double, 3>> sorted(const std::vector<Vector3d>& vertices) {
  std::vector<std::array<double, 3>> all;
  for (const Vector3d& v : vertices) all.push_back({v.x(), v.y(), v.z()});
  std::sort(all.begin(), all.end());
  return all;
}

TEST(ForbiddenRegion, IsReadBackBitByBit) {
  const ForbiddenRegion region = randomRegion();
  const ForbiddenRegion back = parseRegion(regionText(region), "region.obj");
  EXPECT_EQ(back.frame, region.frame);
  EXPECT_EQ(back.inflation, region.inflation);
  EXPECT_EQ(back.shapes, region.shapes);
  EXPECT_EQ(back.protrusion, region.protrusion);
  ASSERT_EQ(back.pieces.size(), region.pieces.size());
  for (std::size_t i = 0; i < region.pieces.size(); ++i) {
    const ForbiddenRegion::Piece &a = region.pieces[i], &b = back.pieces[i];
    EXPECT_EQ(b.cable, a.cable);
    EXPECT_EQ(b.start, a.start);
    EXPECT_EQ(b.end, a.end);
    EXPECT_EQ(b.from, a.from);
    EXPECT_EQ(b.to, a.to);
    EXPECT_EQ(b.branch, a.branch);
    EXPECT_EQ(b.body.radius, a.body.radius);
    EXPECT_EQ(sorted(b.body.core.surface().vertices), sorted(a.body.core.surface().vertices));
    EXPECT_NEAR(b.body.core.volume(), a.body.core.volume(), 1e-12 * a.body.core.volume() + 1e-20);
  }
}

TEST(ForbiddenRegion, PassesOverWhatOtherToolsAdd) {
  std::string text = regionText(randomRegion());
  const std::size_t first = text.find("\no ") + 1;
  text.insert(first, "mtllib some.mtl\nusemtl red\ns off\ng group\n# pieces of cake\n\n");
  // that comment is no number of pieces: the region's own comments end at its first object
  EXPECT_THROW(parseRegion(text, "region.obj"), std::invalid_argument);
  text.replace(text.find("# pieces of cake"), 16, "# cake");
  text += "vn 0 0 1\n";
  EXPECT_EQ(parseRegion(text, "region.obj").pieces.size(), 7u);
}

void expectFault(const std::string& text, const std::string& message) {
  try {
    parseRegion(text, "region.obj");
    FAIL() << "no fault where expected: " << message;
  } catch (const std::invalid_argument& error) {
    EXPECT_NE(std::string(error.what()).find(message), std::string::npos) << error.what();
  }
}

TEST(ForbiddenRegion, SaysWhereAFileIsNoRegion) {
  const std::string text = regionText(randomRegion());
  const auto with = [&](const std::string& what, const std::string& instead) {
    std::string changed = text;
    changed.replace(changed.find(what), what.size(), instead);
    return changed;
  };
  expectFault("", "region.obj:1: the file is empty");
  expectFault("v 1 2 3\n", "region.obj:1: expected '# cable_variation forbidden region, version 1'");
  expectFault(with("version 1", "version 2"), "region.obj:1: expected");
  expectFault(with("# pieces 7", "# pieces 8"), "after 7 pieces, expected 8");
  expectFault(with("# pieces 7\n", ""), "the number of pieces is missing");
  expectFault(with("cable=main", "main"), "region.obj:9: object 'main;s=");
  expectFault(with(";branch=0", ";branch=none"), "branch: 'none' is no whole number");
  expectFault(with(";r=", ";r=-"), "expected at least 0");
  expectFault(with("\nv ", "\nv nan "), "region.obj:10: coordinate: 'nan' is no finite number");
  expectFault(with("\nv ", "\nv 1e999 "), "is no finite number");
  expectFault(with("\nf 1 ", "\nf 1000 "), "facet of vertex 1000, expected one of the object's, 1 to ");
  expectFault(with("\nf 1 ", "\nl 1 "), "unknown keyword 'l'");
  // half of it: in the middle of an object or of a number
  for (const double share : {0.02, 0.3, 0.5, 0.9}) {
    EXPECT_THROW(
        parseRegion(text.substr(0, static_cast<std::size_t>(share * static_cast<double>(text.size()))),
                    "region.obj"),
        std::invalid_argument);
  }
  EXPECT_THROW(readRegion("no/such/region.obj"), FileError);
}

// A cube of 20 mm rounded by 5 mm: a box beside it, and one within.
TEST(ForbiddenRegion, ChecksParts) {
  ForbiddenRegion region;
  region.pieces.push_back({"far", 0, 1, 0, 0, 0, test::boxBody({0.02, 0.02, 0.02}, 0.005, {0.0, 0.0, 1.0})});
  region.pieces.push_back({"near", 0, 1, 0, 0, 0, test::boxBody({0.02, 0.02, 0.02}, 0.005)});
  const DistancePart part(boxMesh({0.1, 0.1, 0.1}));
  const RegionClearance beside =
      checkRegion(region, part, {{0.07, 0.0, 0.0}, Eigen::Quaterniond::Identity()});
  EXPECT_NEAR(beside.distance, 0.005, 1e-12);
  EXPECT_EQ(beside.piece, 1u);
  EXPECT_NEAR(beside.on_region.x(), 0.015, 1e-12);
  EXPECT_NEAR(beside.on_part.x(), 0.02, 1e-12);
  EXPECT_TRUE(beside.colliding.empty());
  const RegionClearance within =
      checkRegion(region, part, {{0.062, 0.0, 0.0}, Eigen::Quaterniond::Identity()});
  EXPECT_NEAR(within.distance, -0.003, 1e-12);
  EXPECT_EQ(within.colliding.size(), 2u);  // the face towards it
  EXPECT_THROW(checkRegion(ForbiddenRegion(), part, Pose()), std::invalid_argument);
}

TEST(ForbiddenRegion, OfAnEnvelopeTakesTheFrameAskedFor) {
  Scene scene;
  scene.harness.cables.push_back(test::uniformCable(0.3, test::roundSection(1, 1, 1, 1), "main"));
  Envelope envelope;
  envelope.inflation = 1e-4;
  envelope.phases = {{0.0, 0.5, 3}, {0.5, 1.0, 4}};
  envelope.frames.resize(2);
  envelope.frames[1].component = "engine";
  envelope.frames[1].pieces.push_back({0, 0.1, 0.2, 1, 0, test::boxBody({0.01, 0.01, 0.01}, 0.004), {}});
  EXPECT_TRUE(forbiddenRegion(scene, envelope).pieces.empty());
  const ForbiddenRegion region = forbiddenRegion(scene, envelope, "engine");
  ASSERT_EQ(region.pieces.size(), 1u);
  EXPECT_EQ(region.frame, "engine");
  EXPECT_EQ(region.pieces[0].cable, "main");
  EXPECT_EQ(region.pieces[0].from, 0.5);
  EXPECT_EQ(region.pieces[0].to, 1.0);
  EXPECT_THROW(forbiddenRegion(scene, envelope, "body"), std::invalid_argument);
}

}  // namespace
}  // namespace cable_variation
