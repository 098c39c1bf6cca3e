// A report on a made-up simulation: its figures, in units a person reads, are all there; and as CSV.
#include <cable_variation/report/simulation_section.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <limits>
#include <sstream>

#include <gtest/gtest.h>

#include <cable_variation/math/normal.h>
#include <cable_variation/report/histogram_chart.h>
#include <cable_variation/report/page.h>
#include <report/well_formed.h>

namespace cable_variation {
namespace {

std::size_t countOf(const std::string& text, const std::string& what) {
  std::size_t count = 0;
  for (std::size_t at = text.find(what); at != std::string::npos; at = text.find(what, at + 1)) ++count;
  return count;
}

class SimulationSection : public testing::Test {
 protected:
  SimulationSection() {
    DesignVariable turn;
    turn.name = "start<rz>";
    turn.unit = "rad";
    turn.lower = -0.3;
    turn.upper = 0.3;
    DesignVariable length = turn;
    length.name = "length";
    length.unit = "m";
    length.nominal = 0.312;
    scene_.design_variables = {turn, length};
    Measure gap;
    gap.name = "D_CAR";
    gap.unit = "m";
    gap.lower = 0.005;
    gap.upper = 0.012;
    Measure moment;
    moment.name = "M";
    moment.unit = "N m";
    moment.type = Measure::Type::clip_moment;
    scene_.measures = {gap, moment};
  }

  // Deviations on a grid of normal scores; a gap of 8 mm ± 1 mm that the first variable alone decides.
  SimulationStatistics simulated(bool failing) const {
    SimulationAccumulator accumulator(scene_, {0, 1}, {0, 1});
    constexpr int kSide = 50;
    for (int i = 0; i < kSide * kSide; ++i) {
      const double x = normalScore((i % kSide + 0.5) / kSide);
      const double y = normalScore((std::floor(i / kSide) + 0.5) / kSide);
      const double deviations[2] = {0.1 * x, 0.1 * y}, values[2] = {0.008 + 0.001 * x, 2.0 + 0.1 * y};
      const double linear[2] = {values[0], 0.0};
      const bool fails = failing && i % 100 == 99;
      accumulator.add(static_cast<std::uint64_t>(i),
                      fails ? SampleOutcome::not_converged : SampleOutcome::solved, deviations, values,
                      linear);
    }
    SimulationStatistics statistics =
        accumulator.statistics(0.95, {LinearMoments{0.008, 0.001}, std::nullopt});
    statistics.seed = 42;
    statistics.wanted = failing ? 10000 : statistics.samples;
    statistics.nominal = {0.008, 2.0};
    return statistics;
  }

  Scene scene_;
};

TEST_F(SimulationSection, PageIsWellFormedAndHasTheFigures) {
  const SimulationStatistics statistics = simulated(false);
  const std::string page = reportPage("A harness", {}, {}, {simulationSection(scene_, statistics, {})});
  EXPECT_EQ(faultOfXml(page), "");
  for (const char* text : {"2500 samples of 2 design variables, sampler monte_carlo, seed 42",
                           "start&lt;rz&gt;", "D_CAR", "99.865 %", "First-order Sobol", "R²",
                           "there is no linear model", "<polyline", "stroke-dasharray:5 3"}) {
    EXPECT_NE(page.find(text), std::string::npos) << text;
  }
  EXPECT_EQ(page.find("Warning"), std::string::npos);
  EXPECT_EQ(countOf(page, "<svg"), 4u);  // a histogram and bars for each measure
  // σ of 1 mm: Cpk 3/3 to the lower limit, which is nearer
  EXPECT_NE(page.find("<td>8</td>"), std::string::npos);
}

TEST_F(SimulationSection, RejectsThatNeverComeHaveNoDigits) {
  scene_.measures[0].upper.reset();
  // 3 σ to the limit of 5 mm: some 1350 ppm
  EXPECT_NE(simulationSection(scene_, simulated(false), {}).html().find(" ppm)"), std::string::npos);
  scene_.measures[0].lower = -0.001;  // 9 σ
  const std::string html = simulationSection(scene_, simulated(false), {}).html();
  EXPECT_NE(html.find(">&lt; 0.001 ppm<"), std::string::npos);
}

TEST_F(SimulationSection, WhatWasNotSolvedIsSaid) {
  const std::string html = simulationSection(scene_, simulated(true), {}).html();
  for (const char* text :
       {"Ended after 2500 of 10000 samples.", "Of 2500 samples 25 came to none.", "<th scope=\"row\">99</th>",
        "5 more are not listed here.", "25 samples have no value", "25 samples are left out here"}) {
    EXPECT_NE(html.find(text), std::string::npos) << text;
  }
}

TEST_F(SimulationSection, LinearSharesStandBesideTheSimulatedOnes) {
  StabilityAnalysis analysis;
  analysis.measures = {1, 0};
  analysis.variables = {1};
  analysis.contribution.resize(2, 1);
  analysis.contribution << 0.4321, 0.1234;
  const std::string html = simulationSection(scene_, simulated(false), {}, &analysis).html();
  // length's shares in D_CAR and in M; the other variable was not analysed
  const std::size_t table = html.find("By the derivatives");
  ASSERT_NE(table, std::string::npos);
  EXPECT_NE(html.find(">12.3 %</td>", table), std::string::npos);
  EXPECT_NE(html.find(">43.2 %</td>", table), std::string::npos);
  EXPECT_NE(html.find(">– %</td>", table), std::string::npos);
}

TEST_F(SimulationSection, WithoutSamplesThereAreNoFigures) {
  SimulationStatistics nothing;
  nothing.wanted = 10;
  EXPECT_NE(simulationSection(scene_, nothing, {}).html().find("Ended after 0 of 10"), std::string::npos);
}

std::vector<std::string> linesOf(const std::string& csv) {
  std::vector<std::string> lines;
  std::istringstream stream(csv);
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

TEST_F(SimulationSection, CsvHasAValueForEachHeading) {
  for (const bool failing : {false, true}) {
    const SimulationStatistics statistics = simulated(failing);
    const auto measures = linesOf(statisticsCsv(scene_, statistics));
    ASSERT_EQ(measures.size(), 3u);
    EXPECT_EQ(countOf(measures[1], ","), countOf(measures[0], ","));
    EXPECT_EQ(countOf(measures[2], ","), countOf(measures[0], ","));
    const auto shares = linesOf(contributionCsv(scene_, statistics));
    ASSERT_EQ(shares.size(), 5u);
    for (const std::string& line : shares) EXPECT_EQ(countOf(line, ","), countOf(shares[0], ","));
  }
  const std::string csv = statisticsCsv(scene_, simulated(false));
  EXPECT_NE(csv.find("\"D_CAR\",\"m\",0.005"), std::string::npos);
}

TEST_F(SimulationSection, AHistogramHasABarForEachFilledBin) {
  const std::string chart = histogramChart({0.0, 1.0, {2, 0, 5, 1}}, {1.5, 2.0, 0.0, {}, 3.0});
  EXPECT_EQ(countOf(chart, "<rect"), 3u);
  EXPECT_EQ(countOf(chart, "fill:var(--bad)"), 1u);  // the last one, beyond the limit
  EXPECT_EQ(countOf(chart, "<polyline"), 0u);
  // a limit far off is left out, and what varies by nothing is one bar
  EXPECT_EQ(countOf(histogramChart({0.0, 1.0, {2, 1}}, {0.0, 0.0, 1.0, {}, 100.0}), "stroke-dasharray:5 3"),
            0u);
  EXPECT_EQ(countOf(histogramChart({7.0, 0.0, {9}}, {7.0, 7.0, 0.0, {}, {}}), "<rect"), 1u);
  EXPECT_EQ(countOf(histogramChart({}, {}), "<rect"), 0u);
  EXPECT_EQ(faultOfXml(chart), "");
}

}  // namespace
}  // namespace cable_variation
