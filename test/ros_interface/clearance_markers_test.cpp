// Clearances of an envelope seen: which are shown, what they say, which triangles are red.
#include <ros_interface/markers/clearance_markers.h>

#include <map>
#include <set>

#include <gtest/gtest.h>

#include <cable_variation/envelope/clearance/clearance_limit.h>

namespace cable_variation_ros {
namespace {

using namespace cable_variation;
using visualization_msgs::Marker;

class Clearances : public testing::Test {
 protected:
  Clearances() {
    scene_.harness.cables.resize(2);
    scene_.harness.cables[0].name = "main";
    scene_.harness.cables[1].name = "branch";
    scene_.components.resize(2);
    scene_.components[0].name = "car";
    scene_.components[1].name = "engine";
    Measure measure;
    measure.cables = {0};
    measure.component = 0;
    measure.lower = 0.005;
    scene_.measures = {measure};
  }

  static EnvelopeClearance to(std::size_t cable, const std::string& component, double distance) {
    EnvelopeClearance clearance;
    clearance.cable = cable;
    clearance.component = component;
    clearance.distance = distance;
    clearance.worst_sample = distance + 1e-4;
    clearance.on_envelope = {0.1, 0.2, 0.3};
    clearance.on_other = {0.1, 0.2, 0.3 + distance};
    clearance.arc_length = 0.2312;
    clearance.time = 0.379;
    return clearance;
  }
  static EnvelopeClearance between(std::size_t cable, std::size_t other, double distance) {
    EnvelopeClearance clearance = to(cable, "", distance);
    clearance.other = other;
    return clearance;
  }

  /// Namespaces of what is shown, and whether it interferes.
  std::map<std::string, bool> shown(const std::vector<EnvelopeClearance>& clearances) const {
    std::map<std::string, bool> result;
    for (const DistanceMark& mark : clearanceMarks(scene_, clearances, false)) {
      result[mark.marker_namespace] = mark.interferes;
    }
    return result;
  }

  Scene scene_;
};

TEST_F(Clearances, TheClosestOfEachPartIsShownIfItIsNear) {
  EXPECT_EQ(shown({to(0, "car", 0.012), to(1, "car", 0.01), to(0, "engine", 0.0199), between(0, 1, 0.003)}),
            (std::map<std::string, bool>{{"interference/clearance/branch/car", false},
                                         {"interference/clearance/main/engine", false},
                                         {"interference/clearance/main/branch", false}}));
  EXPECT_TRUE(shown({to(0, "engine", 0.0201)}).empty());
}

TEST_F(Clearances, OverlapsAndWhatBreaksALimitAreRedAndAllShown) {
  EXPECT_EQ(shown({to(0, "car", 0.0049), to(1, "car", -0.001), to(1, "engine", 0.0001)}),
            (std::map<std::string, bool>{{"interference/clearance/main/car", true},
                                         {"interference/clearance/branch/car", true},
                                         {"interference/clearance/branch/engine", false}}));
  EXPECT_FALSE(shown({to(0, "car", 0.0051)}).begin()->second);
}

TEST_F(Clearances, TwoCablesInterfereIfAShapeThatWasSolvedDoes) {
  EnvelopeClearance pair = between(0, 1, -0.002);
  pair.worst_sample = 0.004;
  EXPECT_TRUE(shown({pair}).empty());
  pair.worst_sample = -0.001;
  EXPECT_EQ(shown({pair}), (std::map<std::string, bool>{{"interference/clearance/main/branch", true}}));
}

TEST_F(Clearances, LimitsAreThoseOfTheScenesDistances) {
  EXPECT_EQ(lowerLimit(scene_, to(0, "car", 0.0)), 0.005);
  EXPECT_EQ(lowerLimit(scene_, to(1, "car", 0.0)), std::nullopt);
  EXPECT_EQ(lowerLimit(scene_, to(0, "engine", 0.0)), std::nullopt);
  EXPECT_EQ(lowerLimit(scene_, between(0, 1, 0.0)), std::nullopt);
  Measure stricter = scene_.measures[0];
  stricter.lower = 0.007;
  Measure cables;
  cables.cables = {1};
  cables.other_cables = {0};
  cables.lower = 0.002;
  scene_.measures.push_back(stricter);
  scene_.measures.push_back(cables);
  EXPECT_EQ(lowerLimit(scene_, to(0, "car", 0.0)), 0.007);
  EXPECT_EQ(lowerLimit(scene_, between(0, 1, 0.0)), 0.002);
}

TEST_F(Clearances, TextTellsDistancePlaceAndTime) {
  EXPECT_EQ(clearanceMarks(scene_, {to(0, "car", 0.004)}, false)[0].text,
            "envelope of main - car 4.0 mm at s = 231 mm");
  EXPECT_EQ(clearanceMarks(scene_, {to(0, "car", -0.0012)}, true)[0].text,
            "envelope of main - car overlap 1.2 mm at s = 231 mm, t = 0.38 s");
}

TEST_F(Clearances, MarkersAreAtBothPointsAndRed) {
  std::multiset<double> balls;
  for (const Marker& marker :
       interferenceMarkers(clearanceMarks(scene_, {to(0, "car", 0.004)}, true)).markers) {
    EXPECT_EQ(marker.ns, "interference/clearance/main/car");
    EXPECT_GT(marker.color.r, marker.color.g + 0.5f);
    if (marker.type == Marker::SPHERE) balls.insert(marker.pose.position.z);
  }
  EXPECT_EQ(balls, (std::multiset<double>{0.3, 0.304}));
}

TEST_F(Clearances, CollidingTrianglesOfAllCablesAreCountedOnce) {
  EnvelopeClearance first = to(0, "car", -0.1), second = to(1, "car", -0.1), third = to(0, "engine", -0.1);
  first.colliding = {1, 5};
  second.colliding = {3, 5};
  third.colliding = {9};
  EXPECT_EQ(collidingTriangles({first, second, third}, "car"), (std::vector<std::uint32_t>{1, 3, 5}));
}

/// Two visuals of a triangle each, the second one metre up.
Component twoTriangles() {
  TriangleMesh mesh;
  mesh.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  mesh.triangles = {{0, 1, 2}};
  Component component;
  component.name = "car";
  component.visuals.resize(2);
  for (Visual& visual : component.visuals) visual.mesh = std::make_shared<TriangleMesh>(mesh);
  component.visuals[1].pose.position.z() = 1.0;
  return component;
}

TEST(RedTriangles, AreTheOnesNamedOffBothSidesOfTheSurface) {
  const std::vector<Marker> markers = triangleMarkers(twoTriangles(), {1}, {});
  ASSERT_EQ(markers.size(), 1u);
  EXPECT_EQ(markers[0].ns, "interference/triangles/car");
  EXPECT_EQ(markers[0].header.frame_id, "car");
  EXPECT_TRUE(markers[0].frame_locked);
  ASSERT_EQ(markers[0].points.size(), 6u);
  std::set<double> heights;
  for (const auto& point : markers[0].points) {
    heights.insert(point.z);
    EXPECT_LE(point.x + point.y, 1.0);
  }
  ASSERT_EQ(heights.size(), 2u);
  EXPECT_NEAR(*heights.begin(), 1.0 - 3e-4, 1e-12);
  EXPECT_NEAR(*heights.rbegin(), 1.0 + 3e-4, 1e-12);
  EXPECT_TRUE(triangleMarkers(twoTriangles(), {}, {}).empty());
}

TEST(RedTriangles, GoWithAPartOffItsDesign) {
  Pose deviation;
  deviation.position.x() = 0.25;
  EXPECT_EQ(triangleMarkers(twoTriangles(), {0}, deviation)[0].pose.position.x, 0.25);
}

}  // namespace
}  // namespace cable_variation_ros
