// Texts that do not hide each other.
#include <ros_interface/markers/label_placing.h>

#include <cmath>

#include <gtest/gtest.h>

namespace cable_variation_ros {
namespace {

constexpr double kHeight = 0.01;  // [m]
const Eigen::Vector3d kPlace(0.1, 0.2, 0.3);

TEST(LabelPlacing, StaysWhereNothingIsInTheWay) {
  LabelPlacing labels;
  EXPECT_EQ(labels.place(kPlace, "one", kHeight), kPlace);
  // Ten letters of 0.01 m are less than 0.1 m wide.
  const Eigen::Vector3d aside = kPlace + Eigen::Vector3d(0.1, 0.0, 0.0);
  EXPECT_EQ(labels.place(aside, "ten letter", kHeight), aside);
  const Eigen::Vector3d below = kPlace - Eigen::Vector3d(0.0, 0.0, 2.0 * kHeight);
  EXPECT_EQ(labels.place(below, "two", kHeight), below);
}

TEST(LabelPlacing, GoesUpByLinesUntilAllAreReadable) {
  LabelPlacing labels;
  std::vector<Eigen::Vector3d> places;
  for (int i = 0; i < 5; ++i) {
    const Eigen::Vector3d wanted = kPlace + Eigen::Vector3d(0.001 * i, 0.0, -0.002 * i);
    places.push_back(labels.place(wanted, "a text", kHeight));
    EXPECT_EQ(places.back().head<2>(), wanted.head<2>());
    EXPECT_GE(places.back().z(), wanted.z());
  }
  for (std::size_t i = 0; i < places.size(); ++i) {
    for (std::size_t k = 0; k < i; ++k) EXPECT_GE(std::abs(places[i].z() - places[k].z()), kHeight);
  }
  EXPECT_LT(places.back().z(), kPlace.z() + 8.0 * kHeight);
}

TEST(LabelPlacing, KeepsTheTextsOfOtherMarkers) {
  visualization_msgs::MarkerArray others;
  others.markers.resize(2);
  visualization_msgs::Marker& text = others.markers[0];
  text.type = visualization_msgs::Marker::TEXT_VIEW_FACING;
  text.text = "WH_Start";
  text.scale.z = kHeight;
  text.pose.position.x = kPlace.x();
  text.pose.position.y = kPlace.y();
  text.pose.position.z = kPlace.z();
  others.markers[1] = text;
  others.markers[1].type = visualization_msgs::Marker::SPHERE;
  others.markers[1].pose.position.x += 1.0;
  LabelPlacing labels;
  labels.keep(others);
  EXPECT_GT(labels.place(kPlace, "x", kHeight).z(), kPlace.z() + kHeight);
  const Eigen::Vector3d ball = kPlace + Eigen::Vector3d::UnitX();
  EXPECT_EQ(labels.place(ball, "x", kHeight), ball);
}

}  // namespace
}  // namespace cable_variation_ros
