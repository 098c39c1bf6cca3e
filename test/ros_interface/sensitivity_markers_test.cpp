// The shape's sensitivity seen: colours by |∂φ/∂x|, arrows along it, a legend that tells both scales.
#include <ros_interface/markers/sensitivity_markers.h>

#include <cmath>

#include <gtest/gtest.h>

#include <ros_interface/markers/colour_map.h>

namespace cable_variation_ros {
namespace {

using namespace cable_variation;
using visualization_msgs::Marker;

/// A straight cable of 0.5 m along x whose points shift along z by twice their arc
/// length per unit, and another that does not move.
class Sensitivity : public testing::Test {
 protected:
  Sensitivity() {
    for (const std::string name : {"bar", "still"}) {
      Cable cable;
      cable.name = name;
      cable.length = 0.5;
      cable.sections = {{0.0, solidSection(0.004, {1e8, 0.25, 2000})}};
      harness_.cables.push_back(cable);
      CableShape shape;
      shape.cable = name;
      std::vector<ShapePointRate> rates;
      for (int i = 0; i <= 5; ++i) {
        ShapePoint point;
        point.arc_length = 0.1 * i;
        point.pose.position.x() = 0.1 * i;
        point.tangent = Eigen::Vector3d::UnitX();
        shape.points.push_back(point);
        rates.emplace_back();
        if (name == std::string("bar")) rates.back().position.z() = 2.0 * point.arc_length;
      }
      equilibrium_.shapes.push_back(shape);
      rate_.shapes.push_back(rates);
    }
    equilibrium_.status = EquilibriumStatus::converged;
    variable_.name = "tilt";
    variable_.unit = "rad";
    variable_.lower = -0.02;
    variable_.upper = 0.05;
  }

  SensitivityView view() const { return sensitivityView(variable_, harness_, equilibrium_, rate_); }
  std::vector<Marker> markersOf(const std::string& cable, int type) const {
    std::vector<Marker> found;
    for (const Marker& marker : view().markers.markers) {
      if (marker.ns == "sensitivity/" + cable && marker.type == type) found.push_back(marker);
    }
    return found;
  }

  Harness harness_;
  Equilibrium equilibrium_;
  EquilibriumRate rate_;
  DesignVariable variable_;
};

TEST_F(Sensitivity, ColoursGoByTheShiftAndCoverTheCable) {
  const std::vector<Marker> segments = markersOf("bar", Marker::MESH_RESOURCE);
  ASSERT_GT(segments.size(), 100u);
  for (const Marker& segment : segments) {
    EXPECT_GT(segment.scale.y, 0.004);
    // The colour is that of the segment's middle; the largest shift, 1, is at the end.
    const double middle = segment.pose.position.x + 0.5 * segment.scale.x;
    const Eigen::Vector3d expected = viridis(middle / 0.5);
    EXPECT_NEAR(segment.color.r, expected[0], 0.02) << middle;
    EXPECT_NEAR(segment.color.g, expected[1], 0.02) << middle;
    EXPECT_NEAR(segment.color.b, expected[2], 0.02) << middle;
  }
}

TEST_F(Sensitivity, ArrowsPointAlongTheShiftAllEnlargedAlike) {
  const std::vector<Marker> arrows = markersOf("bar", Marker::ARROW);
  ASSERT_GT(arrows.size(), 20u);
  // Shift at the upper limit: 2 s * 0.05, at most 50 mm. Enlarged once: twice would pass 16 % of 0.5 m.
  for (const Marker& arrow : arrows) {
    EXPECT_EQ(arrow.points[0].x, arrow.points[1].x);
    EXPECT_NEAR(arrow.points[1].z - arrow.points[0].z, 0.1 * arrow.points[0].x, 1e-12);
  }
  EXPECT_NEAR(arrows.back().points[1].z, 0.05, 1e-12);
  EXPECT_TRUE(markersOf("still", Marker::ARROW).empty());
}

TEST_F(Sensitivity, TheLegendTellsTheRangeInUnitsOfPeople) {
  const Legend legend = view().legend;
  EXPECT_NE(legend.title.find("tilt"), std::string::npos);
  EXPECT_EQ(legend.unit, "mm/deg");
  EXPECT_EQ(legend.minimum, 0.0);
  EXPECT_NEAR(legend.maximum, 1000.0 * M_PI / 180.0, 1e-9);  // 1 m/rad
  EXPECT_EQ(legend.note, "arrows: shift at +2.86 deg");
}

TEST_F(Sensitivity, SmallShiftsAreEnlargedMore) {
  for (ShapePointRate& point : rate_.shapes[0]) point.position *= 1e-2;
  EXPECT_EQ(view().legend.note, "arrows: shift at +2.86 deg, enlarged 100 times");
  variable_.unit = "m";
  variable_.upper = 0.0;
  variable_.lower = -1.3e-3;
  // 13 µm at most; 10000 times that would be 130 mm, more than 80.
  EXPECT_EQ(view().legend.note, "arrows: shift at -1.3 mm, enlarged 5000 times");
  EXPECT_EQ(view().legend.unit, "mm/mm");
  EXPECT_LT(markersOf("bar", Marker::ARROW).back().points[1].z, 0.0);
}

TEST_F(Sensitivity, AVariableThatMovesNothing) {
  rate_.shapes[0] = rate_.shapes[1];
  const SensitivityView still = view();
  EXPECT_EQ(still.legend.maximum, 0.0);
  EXPECT_EQ(still.legend.note, "no cable moves");
  for (const Marker& marker : still.markers.markers) EXPECT_NE(marker.type, int{Marker::ARROW});
  EXPECT_FALSE(still.markers.markers.empty());
}

}  // namespace
}  // namespace cable_variation_ros
