// Production seen: colours by the variation along each cable, sample shapes as lines, a legend that tells
// both.
#include <ros_interface/markers/simulation_markers.h>

#include <gtest/gtest.h>

#include <ros_interface/markers/colour_map.h>
#include <ros_interface/markers/marker_colours.h>

namespace cable_variation_ros {
namespace {

using namespace cable_variation;
using visualization_msgs::Marker;

/// Two straight cables of 0.5 m along x with 6 sections: sections of "bar" have a standard deviation of 2 mm
/// times their share of the length along y and range over 12 mm along z throughout; "still" does not vary.
class SimulationMarkers : public testing::Test {
 protected:
  SimulationMarkers() {
    for (const std::string name : {"bar", "still"}) {
      Cable cable;
      cable.name = name;
      cable.length = 0.5;
      cable.sections = {{0.0, solidSection(0.004, {1e8, 0.25, 2000})}};
      simulation_.harness.cables.push_back(cable);
      CableShape shape;
      shape.cable = name;
      CableVariation variation;
      variation.cable = simulation_.cables.size();
      for (int i = 0; i <= 5; ++i) {
        ShapePoint point;
        point.arc_length = 0.1 * i;
        point.pose.position.x() = 0.1 * i;
        point.tangent = Eigen::Vector3d::UnitX();
        shape.points.push_back(point);
        variation.arc_length.push_back(0.1 * i);
        SectionVariation section;
        if (name == std::string("bar")) {
          section.axes.sigma[0] = 2e-3 * i / 5.0;
          section.range = {0.0, 0.0, 12e-3};
        }
        variation.sections.push_back(section);
      }
      simulation_.linear.nominal.shapes.push_back(shape);
      simulation_.cables.push_back(variation);
    }
    simulation_.linear.nominal.status = EquilibriumStatus::converged;
    scene_.harness = simulation_.harness;
    simulation_.statistics.samples = 10;
    simulation_.statistics.outcomes = {10, 0, 0, 0};
  }

  /// A straight shape of both cables, at a height.
  void keep(SampleOutcome outcome, double z) {
    KeptShape shape;
    shape.outcome = outcome;
    for (int cable = 0; cable < 2; ++cable) {
      Eigen::Matrix3Xd line = Eigen::Matrix3Xd::Zero(3, 6);
      line.row(0).setLinSpaced(0.0, 0.5);
      line.row(2).setConstant(z);
      shape.cables.push_back(line);
    }
    simulation_.shapes.push_back(shape);
  }

  SimulationView view(VariationFigure figure = VariationFigure::six_sigma, bool over_motion = false) const {
    return simulationView(scene_, simulation_, figure, over_motion);
  }
  std::vector<Marker> markersIn(const std::string& marker_namespace, int type) const {
    std::vector<Marker> found;
    for (const Marker& marker : view().markers.markers) {
      if (marker.ns == marker_namespace && marker.type == type) found.push_back(marker);
    }
    return found;
  }

  Scene scene_;
  Simulation simulation_;
};

TEST_F(SimulationMarkers, ColoursGoBySixSigmaAndCoverTheCable) {
  const std::vector<Marker> segments = markersIn("variation/bar", Marker::MESH_RESOURCE);
  ASSERT_GT(segments.size(), 100u);
  for (const Marker& segment : segments) {
    EXPECT_GT(segment.scale.y, 0.004);
    // The colour is that of the segment's middle; linear up to the end, which varies most.
    const double middle = segment.pose.position.x + 0.5 * segment.scale.x;
    const Eigen::Vector3d expected = viridis(middle / 0.5);
    EXPECT_NEAR(segment.color.r, expected[0], 0.02) << middle;
    EXPECT_NEAR(segment.color.g, expected[1], 0.02) << middle;
    EXPECT_NEAR(segment.color.b, expected[2], 0.02) << middle;
  }
  const Eigen::Vector3d lowest = viridis(0.0);
  for (const Marker& segment : markersIn("variation/still", Marker::MESH_RESOURCE)) {
    EXPECT_NEAR(segment.color.r, lowest[0], 1e-6);
  }
}

TEST_F(SimulationMarkers, TheLegendTellsFigureUnitRangeAndSamples) {
  const Legend legend = view().legend;
  EXPECT_NE(legend.title, "");
  EXPECT_EQ(legend.quantity, "6 sigma in the direction that varies most");
  EXPECT_EQ(legend.unit, "mm");
  EXPECT_EQ(legend.minimum, 0.0);
  EXPECT_NEAR(legend.maximum, 12.0, 1e-12);  // six times 2 mm
  EXPECT_EQ(legend.samples, 10u);
  EXPECT_EQ(legend.note, "");
}

TEST_F(SimulationMarkers, RangeInsteadOfSixSigma) {
  simulation_.cables[0].sections[3].range = {0.0, 15e-3, 0.0};
  const Legend legend = view(VariationFigure::range).legend;
  EXPECT_EQ(legend.quantity, "range in the direction that ranges most");
  EXPECT_NEAR(legend.maximum, 15.0, 1e-12);
}

TEST_F(SimulationMarkers, ShapesAreLinesAndThoseThatSnappedAreToldApart) {
  EXPECT_TRUE(markersIn("variation_shapes/bar", Marker::LINE_LIST).empty());
  keep(SampleOutcome::snapped, 0.2);
  keep(SampleOutcome::solved, 0.1);
  keep(SampleOutcome::solved, -0.1);
  for (const std::string cable : {"bar", "still"}) {
    const std::vector<Marker> lines = markersIn("variation_shapes/" + cable, Marker::LINE_LIST);
    ASSERT_EQ(lines.size(), 2u);
    EXPECT_EQ(lines[0].id, 0);
    EXPECT_EQ(lines[0].points.size(), 2u * 5u * 2u);  // shapes, pieces, ends
    EXPECT_EQ(lines[0].points.front().z, 0.1);
    EXPECT_EQ(lines[0].points.back().x, 0.5);
    EXPECT_EQ(lines[1].id, 1);
    EXPECT_EQ(lines[1].points.size(), 1u * 5u * 2u);
    EXPECT_EQ(lines[1].points.front().z, 0.2);
    EXPECT_LT(lines[0].color.a, 1.0);
    // Far from each other, from red and from the light grey of the others.
    const auto colour = [](const Marker& marker) {
      return Eigen::Vector3d(marker.color.r, marker.color.g, marker.color.b);
    };
    EXPECT_GT((colour(lines[0]) - colour(lines[1])).norm(), 0.4);
    EXPECT_GT((colour(lines[1]) - kInterferenceRed.head<3>()).norm(), 0.4);
  }
}

TEST_F(SimulationMarkers, IdsStayWhereNothingIsSolvedOrSnapped) {
  keep(SampleOutcome::snapped, 0.2);
  const std::vector<Marker> lines = markersIn("variation_shapes/bar", Marker::LINE_LIST);
  ASSERT_EQ(lines.size(), 1u);
  EXPECT_EQ(lines[0].id, 1);
}

TEST_F(SimulationMarkers, TheNoteTellsTimeSnapsAndFailures) {
  keep(SampleOutcome::snapped, 0.2);
  simulation_.statistics.samples = 13;
  simulation_.statistics.outcomes = {9, 1, 2, 1};
  simulation_.shown_time = 31.25;
  const Legend legend = view(VariationFigure::six_sigma, true).legend;
  EXPECT_EQ(legend.samples, 10u);  // with a shape
  EXPECT_EQ(legend.note,
            "at t = 31.2 s; lines: 1 of the samples; 1 snapped to another equilibrium (pink lines); 3 more "
            "without an equilibrium");
}

}  // namespace
}  // namespace cable_variation_ros
