// A report on a made-up analysis: its figures, in units a person reads, are all there; and as CSV.
#include <cable_variation/report/stability_section.h>

#include <cmath>
#include <limits>
#include <sstream>

#include <gtest/gtest.h>

#include <cable_variation/report/page.h>
#include <report/well_formed.h>

namespace cable_variation {
namespace {

constexpr double kDegree = M_PI / 180.0;

class StabilitySection : public testing::Test {
 protected:
  StabilitySection() {
    DesignVariable turn;
    turn.name = "start<rz>";
    turn.unit = "rad";
    turn.lower = -5.0 * kDegree;
    turn.upper = 5.0 * kDegree;
    DesignVariable length;
    length.name = "length";
    length.unit = "m";
    length.nominal = 0.312;
    length.lower = -0.003;
    length.upper = 0.003;
    length.distribution = "uniform";
    scene_.design_variables = {turn, length};
    Measure gap;
    gap.name = "D_CAR";
    gap.unit = "m";
    gap.lower = 0.005;
    Measure similarity = gap;
    similarity.name = "D_SIM";
    similarity.type = Measure::Type::similarity;
    similarity.lower.reset();
    scene_.measures = {gap, similarity};

    analysis_.nominal.status = EquilibriumStatus::converged;
    analysis_.nominal.smallest_eigenvalue = 275.5;
    analysis_.variables = {0, 1};
    analysis_.measures = {0, 1};
    analysis_.values.resize(2);
    analysis_.values[0].value = 0.0043;  // below its limit
    analysis_.values[0].unique = false;
    analysis_.jacobian.resize(2, 2);
    analysis_.jacobian << -0.0021 / kDegree, 0.25, 0.0031 / kDegree, 0.5;
    analysis_.one_sided = {false, true};
    analysis_.variable_sigma = Eigen::Vector2d(5.0 / 3.0 * kDegree, 0.003 / std::sqrt(3.0));
    analysis_.mean_shift = Eigen::Vector2d(1e-4, 0.0);
    analysis_.sigma = Eigen::Vector2d(0.0035, 0.005);
    analysis_.contribution.resize(2, 2);
    analysis_.contribution << 0.985, 0.015, 0.97, 0.03;
    analysis_.worst_low = Eigen::Vector2d(-0.01125, 0.0);
    analysis_.worst_high = Eigen::Vector2d(0.01125, 0.017);
    analysis_.low_high = {{{0.0131, std::numeric_limits<double>::quiet_NaN()}, {0.0035, 0.0051}},
                          {{0.0161, 0.0157}, {0.0015, 0.0016}}};
    analysis_.eigenvalue_low = {201.25, 280.0};
    analysis_.eigenvalue_high = {std::numeric_limits<double>::quiet_NaN(), 271.0};
    analysis_.coupling = Coupling::coupled;
    analysis_.warnings = {"start<rz> at its upper limit: no equilibrium"};
  }

  Scene scene_;
  StabilityAnalysis analysis_;
};

TEST_F(StabilitySection, HasTheAnalysisFiguresInMillimetresAndDegrees) {
  const std::string html = stabilitySection(scene_, analysis_, {{"length", 0.3}}).html();
  EXPECT_EQ(faultOfXml(reportPage("report", {}, {}, {stabilitySection(scene_, analysis_, {})})), "");
  for (const char* expected :
       {"<td class=\"out\">4.3</td>",           // value below the limit of 5 mm
        "−2.1 mm/deg", "0.25 mm/mm", "98.5 %",  // derivative and share
        "275.5 N/m", "201.2", "3.5",            // eigenvalues, sigma
        "<td class=\"out\">−6.95</td>",         // worst case: 4.3 - 11.25
        "<td>300</td>",                         // the length analysed, not the scene's
        "start&lt;rz&gt; at its upper limit: no equilibrium", "more than one place", "D_SIM *"}) {
    EXPECT_NE(html.find(expected), std::string::npos) << expected;
  }
  EXPECT_EQ(html.find("<td>312</td>"), std::string::npos);
}

TEST_F(StabilitySection, SaysWhatIsNotDefinedAndWhy) {
  constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
  analysis_.values[0].value = std::numeric_limits<double>::infinity();
  analysis_.jacobian.row(0).setConstant(kNone);
  analysis_.contribution.row(0).setConstant(kNone);
  analysis_.sigma[0] = analysis_.mean_shift[0] = analysis_.worst_low[0] = analysis_.worst_high[0] = kNone;
  analysis_.undefined = {"the value is infinite at the nominal design (straight everywhere)", ""};
  SnapWithin snap;
  snap.variable = 0;
  snap.deviation = -3.5 * kDegree;
  snap.jump = 0.066;
  analysis_.snaps = {snap};
  const ReportSection section = stabilitySection(scene_, analysis_, {});
  EXPECT_EQ(faultOfXml(reportPage("report", {}, {}, {section})), "");
  EXPECT_EQ(section.html().find("nan"), std::string::npos);
  for (const char* expected :
       {"derivatives not defined: the value is infinite", "D_CAR: not defined: the value", "D_CAR: no lines",
        ">not defined</td>", "97 %"})
    EXPECT_NE(section.html().find(expected), std::string::npos) << expected;
  const std::string csv = stabilityCsv(scene_, analysis_, {});
  EXPECT_NE(csv.find("\"not defined: the value is infinite at the nominal design (straight everywhere)\""),
            std::string::npos);
  EXPECT_NE(
      csv.find("\"high not defined: no equilibrium there; low is of another equilibrium: a snap at -3.5 "
               "deg\""),
      std::string::npos)
      << csv;
}

TEST_F(StabilitySection, WithoutLowAndHighLeavesThemOut) {
  analysis_.low_high.clear();
  analysis_.eigenvalue_low.clear();
  analysis_.eigenvalue_high.clear();
  const ReportSection section = stabilitySection(scene_, analysis_, {});
  EXPECT_EQ(section.html().find("High, low"), std::string::npos);
  EXPECT_EQ(faultOfXml(reportPage("report", {}, {}, {section})), "");
}

TEST_F(StabilitySection, WithoutEquilibriumSaysWhy) {
  StabilityAnalysis failed;
  failed.nominal.status = EquilibriumStatus::impossible;
  failed.nominal.message = "cable 'main' is 3 mm too short";
  const std::string html = stabilitySection(scene_, failed, {}).html();
  EXPECT_NE(html.find("3 mm too short"), std::string::npos);
  EXPECT_EQ(html.find("<table>"), std::string::npos);
}

TEST_F(StabilitySection, AsCsvReadsBackToTheLastBit) {
  scene_.design_variables[1].name = "a \"b\", c";
  std::istringstream lines(stabilityCsv(scene_, analysis_, {}));
  std::vector<std::vector<std::string>> rows;
  for (std::string line; std::getline(lines, line);) {
    ASSERT_EQ(line.back(), '\r');
    line.pop_back();
    std::vector<std::string> fields{""};
    bool inside = false;
    for (const char c : line) {
      if (c == '"') inside = !inside;
      if (c == ',' && !inside) {
        fields.emplace_back();
      } else {
        fields.back() += c;
      }
    }
    rows.push_back(fields);
  }
  ASSERT_EQ(rows.size(), 1u + 4u);
  for (const auto& row : rows) ASSERT_EQ(row.size(), rows[0].size());
  const auto field = [&](std::size_t row, const std::string& name) {
    for (std::size_t i = 0; i < rows[0].size(); ++i) {
      if (rows[0][i] == name) return rows[row][i];
    }
    return std::string("no such column");
  };
  EXPECT_EQ(field(1, "measure"), "\"D_CAR\"");
  EXPECT_EQ(field(2, "variable"), "\"a \"\"b\"\", c\"");
  EXPECT_EQ(std::stod(field(1, "derivative")), analysis_.jacobian(0, 0));
  EXPECT_EQ(std::stod(field(4, "contribution")), analysis_.contribution(1, 1));
  EXPECT_EQ(field(1, "high"), "nan");
  EXPECT_EQ(field(3, "lower_limit"), "");
  EXPECT_EQ(field(3, "one_sided"), "1");
  EXPECT_EQ(std::stod(field(2, "nominal")), 0.312);
}

}  // namespace
}  // namespace cable_variation
