// What acts along a cable, against closed forms, and how it is drawn.
#include <cable_variation/report/cable_profile.h>

#include <algorithm>
#include <cmath>
#include <sstream>

#include <gtest/gtest.h>

#include <cable_variation/equilibrium/bend_radius.h>
#include <cable_variation/report/chart_axis.h>
#include <cable_variation/report/profile_chart.h>
#include <measures/solved_scene.h>
#include <report/page_tables.h>

namespace cable_variation {
namespace {

test::Solved solved(const Harness& harness) {
  EquilibriumSolver solver;
  return test::solveAt(test::sceneOf(harness), {}, solver);
}

TEST(CableProfile, OfAHangingCableIsTheWeightBelow) {
  constexpr double kLength = 0.5, kMass = 0.2;  // [m], [kg/m]
  Harness harness =
      test::cantilever(test::uniformCable(kLength, test::roundSection(1e5, 4e4, 0.1, 0.1, kMass)));
  harness.clips[0].pose = test::clampAlong(Eigen::Vector3d::Zero(), -Eigen::Vector3d::UnitZ(), 0.0);
  const test::Solved at = solved(harness);
  ASSERT_TRUE(at.equilibrium.converged()) << at.equilibrium.message;
  const std::vector<ProfilePoint> profile = cableProfile(at.view(), 0);
  ASSERT_GT(profile.size(), 8u);
  EXPECT_EQ(profile.front().arc_length, 0.0);
  EXPECT_NEAR(profile.back().arc_length, kLength, 1e-12);
  for (const ProfilePoint& point : profile) {
    EXPECT_NEAR(point.axial, kMass * 9.81 * (kLength - point.arc_length), 1e-4);
    EXPECT_NEAR(point.force, point.axial, 1e-4);
    EXPECT_NEAR(point.moment, 0.0, 1e-6);
    EXPECT_NEAR(point.curvature, 0.0, 1e-5);
  }
}

TEST(CableProfile, OfAPureMomentIsAnArc) {
  constexpr double kStiffness = 0.02, kMoment = 0.1;  // [N m²], [N m]: a radius of 200 mm
  Harness harness = test::cantilever(test::uniformCable(0.3, test::roundSection(1e4, 4e3, 0.01, kStiffness)),
                                     Eigen::Vector3d::Zero());
  harness.loads = {test::loadAt(0, 0.3, Eigen::Vector3d::Zero(), {0.0, kMoment, 0.0})};
  const test::Solved at = solved(harness);
  ASSERT_TRUE(at.equilibrium.converged()) << at.equilibrium.message;
  for (const ProfilePoint& point : cableProfile(at.view(), 0)) {
    EXPECT_NEAR(point.moment, kMoment, 1e-4);
    EXPECT_NEAR(point.torsion, 0.0, 1e-4);
    EXPECT_NEAR(point.force, 0.0, 1e-3);
    EXPECT_NEAR(point.curvature, kMoment / kStiffness, 1e-3 * kMoment / kStiffness);
  }
}

TEST(CableProfile, ChartsHaveTheLimitsOfTheirMeasures) {
  Harness harness = test::caseH();
  Scene scene = test::sceneOf(harness);
  Measure bend = test::measure(Measure::Type::bend_radius, "bend<limit>");
  EquilibriumSolver solver;
  const test::Solved at = test::solveAt(scene, {}, solver);
  bend.lower = 0.9 * smallestBendRadius(at.equilibrium.shapes[0]).radius;
  scene.measures = {bend};
  const auto charts = profileCharts(scene, at.view(), 0);
  ASSERT_EQ(charts.size(), 4u);
  for (const auto& [svg, caption] : charts) EXPECT_NO_THROW(ReadPage{svg}) << caption;
  EXPECT_EQ(charts[0].first.find("limit"), std::string::npos);
  EXPECT_NE(charts[2].first.find("bend&lt;limit&gt;"), std::string::npos);
  EXPECT_NE(charts[3].first.find("bend&lt;limit&gt;"), std::string::npos);
  EXPECT_NE(charts[3].second.find("bend radius"), std::string::npos);
}

TEST(ChartAxis, StepsAreRoundAndHoldTheValues) {
  const auto expectAxis = [](double low, double high, int count, const std::vector<double>& ticks) {
    const ChartAxis axis = roundAxis(low, high, count);
    ASSERT_EQ(axis.ticks.size(), ticks.size()) << low << " to " << high;
    for (std::size_t i = 0; i < ticks.size(); ++i) EXPECT_NEAR(axis.ticks[i], ticks[i], 1e-12);
    EXPECT_EQ(axis.low, axis.ticks.front());
    EXPECT_EQ(axis.high, axis.ticks.back());
  };
  expectAxis(0.0, 1.0, 4, {0.0, 0.5, 1.0});
  expectAxis(0.0, 0.0039, 4, {0.0, 0.001, 0.002, 0.003, 0.004});
  expectAxis(-3.0, 7.0, 4, {-5.0, 0.0, 5.0, 10.0});
  expectAxis(0.0, 312.0, 6, {0.0, 100.0, 200.0, 300.0, 400.0});
  for (const double level : {0.0, 5.0, -1e-3}) {
    const ChartAxis axis = roundAxis(level, level, 4);
    EXPECT_LE(axis.low, level);
    EXPECT_GE(axis.high, level);
    EXPECT_LT(axis.low, axis.high);
    EXPECT_LT(axis.ticks.size(), 9u);
  }
}

TEST(ProfileChart, LinesEndWhereTheyLeaveTheScale) {
  ProfileChart chart;
  chart.most = 10.0;
  chart.lines = {
      {"one", "stroke:red", {{0.0, HUGE_VAL}, {1.0, 5.0}, {2.0, 8.0}, {3.0, 20.0}, {4.0, 5.0}, {5.0, 5.0}}}};
  const ReadPage page(profileChart(chart));
  const auto lines = page.all("polyline");
  ASSERT_EQ(lines.size(), 2u);
  double highest = HUGE_VAL;  // on the screen, so the least
  for (const auto* line : lines) {
    std::string points = line->Attribute("points");
    std::replace(points.begin(), points.end(), ',', ' ');
    std::istringstream stream(points);
    for (double x = 0.0, y = 0.0; stream >> x >> y;) highest = std::min(highest, y);
  }
  EXPECT_NEAR(highest, 38.0, 0.06);  // the upper end of the scale, 10, and not where 20 would be
}

TEST(ProfileChart, OfNothingIsWellFormed) {
  EXPECT_NO_THROW(ReadPage{profileChart({})});
  ProfileChart chart;
  chart.lines = {{"straight", "", {{0.0, HUGE_VAL}, {1.0, HUGE_VAL}}}};
  chart.limits = {{1.0, "limit"}};
  EXPECT_NO_THROW(ReadPage{profileChart(chart)});
  EXPECT_EQ(profileChart(chart).find("nan"), std::string::npos);
  EXPECT_EQ(profileChart(chart).find("inf"), std::string::npos);
}

}  // namespace
}  // namespace cable_variation
