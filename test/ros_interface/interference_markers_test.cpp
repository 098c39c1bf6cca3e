// Closest pairs seen: red only where parts are too close.
#include <ros_interface/markers/interference_markers.h>

#include <map>
#include <set>

#include <gtest/gtest.h>

namespace cable_variation_ros {
namespace {

using namespace cable_variation;
using visualization_msgs::Marker;
using visualization_msgs::MarkerArray;

class Interference : public testing::Test {
 protected:
  Interference() {
    scene_.measures.resize(2);
    scene_.measures[0].name = "D_CAR";
    scene_.measures[0].lower = 0.005;
    scene_.measures[1].name = "F_CLIP";
    scene_.measures[1].type = Measure::Type::clip_force;
    value_.has_place = value_.has_other = true;
    value_.arc_length = 0.2312;
    value_.point = {0.1, 0.2, 0.3};
    value_.other = {0.1, 0.2, 0.308};
  }

  std::vector<Marker> markersAt(double distance) {
    value_.value = distance;
    return interferenceMarkers(distanceMarks(scene_, {0}, {value_})).markers;
  }
  bool redAt(double distance) {
    std::set<bool> red;
    for (const Marker& marker : markersAt(distance)) red.insert(marker.color.r > marker.color.g + 0.5f);
    EXPECT_EQ(red.size(), 1u);
    return red == std::set<bool>{true};
  }
  std::string textAt(double distance) {
    for (const Marker& marker : markersAt(distance)) {
      if (marker.type == Marker::TEXT_VIEW_FACING) return marker.text;
    }
    return "";
  }

  Scene scene_;
  MeasureValue value_;
};

TEST_F(Interference, RedBelowTheLowerLimitAndWherePartsOverlap) {
  EXPECT_TRUE(redAt(0.0049));
  EXPECT_FALSE(redAt(0.0051));
  scene_.measures[0].lower.reset();
  EXPECT_FALSE(redAt(0.0049));
  EXPECT_TRUE(redAt(-0.0001));
}

TEST_F(Interference, TextTellsDistanceAndPlace) {
  EXPECT_EQ(textAt(0.004), "D_CAR 4.0 mm at s = 231 mm");
  EXPECT_EQ(textAt(-0.0012), "D_CAR overlap 1.2 mm at s = 231 mm");
  EXPECT_EQ(textAt(0.1234), "D_CAR 123 mm at s = 231 mm");
}

TEST_F(Interference, BallsAndLineAreAtThePair) {
  std::multiset<double> balls;
  std::map<double, double> lines;  // middle and length along z
  for (const Marker& marker : markersAt(0.008)) {
    EXPECT_EQ(marker.ns, "interference/D_CAR");
    EXPECT_EQ(marker.header.frame_id, "world");
    if (marker.type == Marker::SPHERE) balls.insert(marker.pose.position.z);
    if (marker.type == Marker::CYLINDER) lines.emplace(marker.pose.position.z, marker.scale.z);
  }
  EXPECT_EQ(balls, (std::multiset<double>{0.3, 0.308}));
  ASSERT_EQ(lines.size(), 2u);  // the pair's, and the text's leader further up
  EXPECT_NEAR(lines.begin()->first, 0.304, 1e-12);
  EXPECT_NEAR(lines.begin()->second, 0.008, 1e-12);
}

TEST_F(Interference, OtherMeasuresAndPairsThatAreNoneShowNothing) {
  EXPECT_TRUE(distanceMarks(scene_, {1}, {value_}).empty());
  value_.has_other = false;
  EXPECT_TRUE(markersAt(0.1).empty());
}

}  // namespace
}  // namespace cable_variation_ros
