// An analysis and its measures as messages, and which variable is worth looking at first.
#include <ros_interface/conversion/stability_conversion.h>

#include <limits>

#include <gtest/gtest.h>

#include <cable_variation/sensitivity/most_telling_variable.h>
#include <ros_interface/conversion/measure_conversion.h>

namespace cable_variation_ros {
namespace {

using namespace cable_variation;

DesignVariable variableOf(const std::string& name, double lower, double upper) {
  DesignVariable variable;
  variable.name = name;
  variable.target = ClipTranslation{0, Axis::z};
  variable.unit = "m";
  variable.lower = lower;
  variable.upper = upper;
  return variable;
}

Measure measureOf(const std::string& name, Measure::Type type, const std::string& unit) {
  Measure measure;
  measure.name = name;
  measure.type = type;
  measure.unit = unit;
  return measure;
}

/// Two measures by three variables, every figure different.
class StabilityConversion : public testing::Test {
 protected:
  StabilityConversion() {
    scene_.harness.cables.resize(2);
    scene_.harness.cables[0].name = "main";
    scene_.harness.cables[1].name = "branch";
    scene_.harness.clips.resize(1);
    scene_.harness.clips[0].name = "start";
    scene_.components.resize(1);
    scene_.components[0].name = "car";
    scene_.design_variables = {variableOf("a", -1e-3, 1e-3), variableOf("b", -2e-3, 2e-3),
                               variableOf("c", -3e-3, 3e-3)};
    scene_.measures = {measureOf("force", Measure::Type::clip_force, "N"),
                       measureOf("gap", Measure::Type::distance, "m")};
    scene_.measures[1].component = 0;
    scene_.measures[1].cables = {1};

    analysis_.variables = {2, 0, 1};
    analysis_.measures = {1, 0};
    analysis_.values.resize(2);
    analysis_.values[0].value = 0.006;
    analysis_.values[1].value = 7.0;
    analysis_.jacobian.resize(2, 3);
    analysis_.jacobian << 1.0, 2.0, 3.0, 4.0, 5.0, 6.0;
    analysis_.contribution.resize(2, 3);
    analysis_.contribution << 0.2, 0.7, 0.1, 0.1, 0.1, 0.8;
    analysis_.one_sided = {false, true};
    analysis_.variable_sigma = Eigen::Vector3d(0.3, 0.1, 0.2);
    analysis_.mean_shift = Eigen::Vector2d(0.0, 0.5);
    analysis_.sigma = Eigen::Vector2d(0.001, 2.0);
    analysis_.worst_low = Eigen::Vector2d(-0.004, -8.0);
    analysis_.worst_high = Eigen::Vector2d(0.005, 9.0);
    analysis_.low_high = {{{1, 2}, {3, 4}, {5, std::numeric_limits<double>::quiet_NaN()}},
                          {{7, 8}, {9, 10}, {11, 12}}};
    analysis_.eigenvalue_low = {21, 22, 23};
    analysis_.eigenvalue_high = {24, 25, 26};
    analysis_.coupling = Coupling::decoupled;
    analysis_.warnings = {"close to a snap"};
    analysis_.rates.resize(3);
    for (EquilibriumRate& rate : analysis_.rates) rate.shapes.resize(1, std::vector<ShapePointRate>(1));
  }

  std::string telling() const {
    const auto column = mostTellingVariable(scene_, analysis_);
    return column ? scene_.design_variables[analysis_.variables[*column]].name : "none";
  }

  Scene scene_;
  StabilityAnalysis analysis_;
};

TEST_F(StabilityConversion, MatricesGoRowByRowInTheOrderOfTheAnalysis) {
  const AnalyzeStabilityResponse response = toResponse(scene_, {{"a", 0.25}}, analysis_, {}, {});
  ASSERT_EQ(response.variables.size(), 3u);
  EXPECT_EQ(response.variables[0].name, "c");
  EXPECT_EQ(response.variables[1].nominal, 0.25);
  EXPECT_EQ(response.variables[2].upper, 2e-3);
  ASSERT_EQ(response.measures.size(), 2u);
  EXPECT_EQ(response.measures[0].name, "gap");
  EXPECT_EQ(response.jacobian, (std::vector<double>{1, 2, 3, 4, 5, 6}));
  EXPECT_EQ(response.contribution[5], 0.8);
  EXPECT_EQ(response.low, (std::vector<double>{1, 3, 5, 7, 9, 11}));
  EXPECT_EQ(response.high[4], 10.0);
  EXPECT_TRUE(std::isnan(response.high[2]));
  EXPECT_EQ(response.one_sided, (std::vector<std::uint8_t>{0, 1}));
  EXPECT_EQ(response.variable_sigma, (std::vector<double>{0.3, 0.1, 0.2}));
  EXPECT_EQ(response.mean_shift[1], 0.5);
  EXPECT_EQ(response.sigma[1], 2.0);
  EXPECT_EQ(response.worst_low[1], -8.0);
  EXPECT_EQ(response.worst_high[0], 0.005);
  EXPECT_EQ(response.eigenvalue_low[2], 23.0);
  EXPECT_EQ(response.eigenvalue_high[0], 24.0);
  EXPECT_EQ(response.coupling, "decoupled");
  EXPECT_EQ(response.warnings, analysis_.warnings);
}

TEST_F(StabilityConversion, ComponentsTellTheVertexThatVariesMost) {
  auto mesh = std::make_shared<TriangleMesh>();
  mesh->vertices = {{0.0, 0.0, 0.0}, {0.1, 0.0, 0.0}, {0.0, 0.0, 0.05}};
  scene_.components[0].visuals.resize(1);
  scene_.components[0].visuals[0].mesh = mesh;
  ComponentVariation variation;
  variation.origin = {1.0, 2.0, 3.0};
  variation.covariance(4, 4) =
      1e-4;  // turns about y by 0.01 rad: the farthest vertex, 0.1 m along x, moves along z
  Pose pose;
  pose.position = variation.origin;
  const auto response = toResponse(scene_, {}, analysis_, {variation}, {{"car", pose}});
  ASSERT_EQ(response.components.size(), 1u);
  EXPECT_EQ(response.components[0].component, "car");
  EXPECT_NEAR(response.components[0].largest_six_sigma, 6e-3, 1e-12);
  EXPECT_NEAR(response.components[0].at.x, 1.1, 1e-12);
  EXPECT_NEAR(std::abs(response.components[0].direction.z), 1.0, 1e-9);
}

TEST_F(StabilityConversion, TheTightestMeasureTellsWhichVariableMatters) {
  scene_.measures[0].upper = 10.0;  // force: (10 - 7.5) / 2 = 1.25 sigma left, most of it b's
  EXPECT_EQ(telling(), "b");
  scene_.measures[1].lower = 0.005;  // gap: 1 sigma left, most of it a's
  EXPECT_EQ(telling(), "a");
  scene_.measures[0].upper = 7.0;  // beyond its limit
  EXPECT_EQ(telling(), "b");
  analysis_.sigma.setZero();  // nothing varies: what shifts the cables most at its limits, c by 3 mm
  for (EquilibriumRate& rate : analysis_.rates) rate.shapes[0][0].position.x() = 1.0;
  EXPECT_EQ(telling(), "c");
  analysis_.variables.clear();
  EXPECT_EQ(telling(), "none");
}

TEST_F(StabilityConversion, AMeasureTellsItsLimitsAndItsPlace) {
  Measure& gap = scene_.measures[1];
  gap.lower = 0.005;
  MeasureValue value;
  value.value = 0.004;
  value.unique = false;
  value.note = "two places";
  value.has_place = value.has_other = true;
  value.cable = 1;
  value.arc_length = 0.12;
  value.point = {1, 2, 3};
  value.other = {4, 5, 6};
  const MeasureResult result = toResult(gap, value, scene_);
  EXPECT_EQ(result.type, "distance");
  EXPECT_EQ(result.cable, "branch");
  EXPECT_TRUE(result.has_lower);
  EXPECT_FALSE(result.has_upper);
  EXPECT_FALSE(result.within);
  EXPECT_FALSE(result.unique);
  EXPECT_EQ(result.note, "two places");
  EXPECT_EQ(result.arc_length, 0.12);
  EXPECT_EQ(result.point.y, 2.0);
  EXPECT_EQ(result.other.z, 6.0);

  const MeasureInfo info = toInfo(gap, scene_);
  EXPECT_EQ(info.component, "car");
  EXPECT_EQ(info.cables, std::vector<std::string>{"branch"});
  EXPECT_EQ(info.clip, "");
  EXPECT_EQ(toInfo(scene_.measures[0], scene_).clip, "start");
}

}  // namespace
}  // namespace cable_variation_ros
