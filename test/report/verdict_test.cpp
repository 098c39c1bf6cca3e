// Which figures make a measure pass, whatever they were computed by.
#include <cable_variation/report/verdict.h>

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

namespace cable_variation {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

/// One measure, at least 5 and at most 25, of a design at 10.
class Verdicts : public testing::Test {
 protected:
  Verdicts() {
    Measure measure;
    measure.name = "M";
    measure.unit = "N";
    measure.type = Measure::Type::clip_force;
    measure.lower = 5.0;
    measure.upper = 25.0;
    scene_.measures = {measure};
    evidence_ = {{0}, {10.0}};
    linear_.measures = {0};
    linear_.values.resize(1);
    linear_.values[0].value = 10.0;
    linear_.undefined = {""};
    linear_.mean_shift = linear_.worst_low = linear_.worst_high = Eigen::VectorXd::Zero(1);
  }

  MeasureVerdict verdict() const { return verdictsOf(scene_, evidence_).front(); }

  MeasureVerdict withSigma(double sigma, double shift = 0.0) {
    linear_.sigma = Eigen::VectorXd::Constant(1, sigma);
    linear_.mean_shift[0] = shift;
    linear_.worst_low[0] = -4.0 * sigma;
    linear_.worst_high[0] = 3.0 * sigma;
    evidence_.linear = &linear_;
    return verdict();
  }

  MeasureVerdict simulated(double cpk, double outside) {
    MeasureStatistics statistics;
    statistics.capability.emplace();
    statistics.capability->cpk = cpk;
    statistics.capability->outside_at_worst = outside;
    simulation_.measures = {0};
    simulation_.statistics = {statistics};
    evidence_.simulation = &simulation_;
    return verdict();
  }

  Scene scene_;
  StabilityAnalysis linear_;
  SimulationStatistics simulation_;
  MeasureEvidence evidence_;
};

TEST_F(Verdicts, OfTheDesignAlone) {
  EXPECT_EQ(verdict().verdict, Verdict::pass);
  EXPECT_STREQ(verdict().basis, "design");
  EXPECT_TRUE(std::isnan(verdict().cpk));
  for (const double outside : {4.999, 25.001}) {
    evidence_.values = {outside};
    EXPECT_EQ(verdict().verdict, Verdict::fail);
  }
  evidence_.values = {kNaN};
  EXPECT_EQ(verdict().verdict, Verdict::unknown);
  scene_.measures[0].lower.reset();
  scene_.measures[0].upper.reset();
  EXPECT_EQ(verdict().verdict, Verdict::no_limits);
}

TEST_F(Verdicts, ByTheFirstOrderSpread) {
  // 5 above the lower limit: Cpk = 5/3σ
  EXPECT_NEAR(withSigma(1.0).cpk, 5.0 / 3.0, 1e-12);
  EXPECT_EQ(withSigma(1.0).verdict, Verdict::pass);
  EXPECT_EQ(withSigma(5.0 / 3.0 / 1.2).verdict, Verdict::marginal);
  EXPECT_EQ(withSigma(5.0 / 3.0 / 0.99).verdict, Verdict::fail);
  EXPECT_EQ(withSigma(1.0, -3.0).verdict, Verdict::fail);   // the mean 2 above it
  EXPECT_NEAR(withSigma(1.0, 10.0).cpk, 5.0 / 3.0, 1e-12);  // 5 below the upper limit
  EXPECT_STREQ(withSigma(1.0).basis, "first order");
  EXPECT_EQ(withSigma(1.0).worst_low, 6.0);
  EXPECT_EQ(withSigma(1.0).worst_high, 13.0);
  EXPECT_EQ(withSigma(0.0).verdict, Verdict::pass);  // it does not vary
}

TEST_F(Verdicts, WhatIsNotDefinedToFirstOrderLeavesTheDesign) {
  linear_.undefined = {"it is infinite"};
  EXPECT_EQ(withSigma(kNaN).verdict, Verdict::pass);
  EXPECT_STREQ(verdict().basis, "design");
}

TEST_F(Verdicts, BySimulationWhateverTheLinearModelSays) {
  withSigma(100.0);
  EXPECT_EQ(simulated(1.4, 0.0).verdict, Verdict::pass);
  EXPECT_STREQ(verdict().basis, "simulation");
  EXPECT_EQ(simulated(1.2, 0.001).verdict, Verdict::marginal);
  EXPECT_EQ(simulated(0.9, 0.0).verdict, Verdict::fail);
  EXPECT_EQ(simulated(1.4, 0.01).verdict, Verdict::fail);  // samples outside or without a value
  EXPECT_EQ(simulated(kNaN, 0.0).verdict, Verdict::unknown);
  EXPECT_EQ(verdict().worst_low, -390.0);
}

TEST_F(Verdicts, OutsideAtTheDesignFailsHoweverLittleItVaries) {
  evidence_.values = {4.0};
  EXPECT_EQ(simulated(2.0, 0.0).verdict, Verdict::fail);
  EXPECT_STREQ(verdict().basis, "design");
}

class ClearanceVerdicts : public testing::Test {
 protected:
  ClearanceVerdicts() {
    scene_.harness.cables.resize(2);
    scene_.harness.cables[0].name = "main";
    scene_.harness.cables[1].name = "branch";
    scene_.components.resize(1);
    scene_.components[0].name = "bay";
    Measure measure;
    measure.name = "D";
    measure.unit = "m";
    measure.type = Measure::Type::distance;
    measure.cables = {0, 1};
    measure.component = 0;
    measure.lower = 0.005;
    scene_.measures = {measure};
  }

  static EnvelopeClearance of(std::size_t cable, double bound, double solved) {
    EnvelopeClearance clearance;
    clearance.cable = cable;
    clearance.component = "bay";
    clearance.distance = bound;
    clearance.worst_sample = solved;
    return clearance;
  }

  MeasureVerdict verdict(const std::vector<EnvelopeClearance>& clearances) const {
    MeasureEvidence evidence{{0}, {0.01}};
    evidence.clearances = &clearances;
    return verdictsOf(scene_, evidence).front();
  }

  Scene scene_;
};

TEST_F(ClearanceVerdicts, BoundAndWhatWasSolved) {
  EXPECT_EQ(verdictOf(scene_, of(0, 0.006, 0.007)), Verdict::pass);
  EXPECT_EQ(verdictOf(scene_, of(0, 0.004, 0.007)), Verdict::marginal);
  EXPECT_EQ(verdictOf(scene_, of(0, 0.004, 0.0045)), Verdict::fail);
  scene_.measures.clear();
  EXPECT_EQ(verdictOf(scene_, of(0, 0.004, 0.0045)), Verdict::no_limits);
  EXPECT_EQ(verdictOf(scene_, of(0, -0.001, 0.001)), Verdict::marginal);
  EXPECT_EQ(verdictOf(scene_, of(0, -0.002, -0.001)), Verdict::fail);  // an overlap needs no limit to be one
}

TEST_F(ClearanceVerdicts, AMeasureIsAsGoodAsItsWorstCable) {
  const MeasureVerdict good = verdict({of(0, 0.006, 0.007), of(1, 0.008, 0.009)});
  EXPECT_EQ(good.verdict, Verdict::pass);
  EXPECT_EQ(good.worst_low, 0.006);
  EXPECT_STREQ(good.basis, "worst case");
  EXPECT_EQ(verdict({of(0, 0.006, 0.007), of(1, 0.004, 0.009)}).verdict, Verdict::marginal);
  EXPECT_EQ(verdict({of(0, 0.003, 0.004), of(1, 0.004, 0.009)}).verdict, Verdict::fail);
}

TEST_F(ClearanceVerdicts, AllTogether) {
  const auto overall = [&](double bound, double solved) {
    const std::vector<EnvelopeClearance> clearances{of(0, bound, solved)};
    return overallVerdict(scene_, {verdict(clearances)}, clearances);
  };
  EXPECT_EQ(overall(0.006, 0.007).verdict, Verdict::pass);
  EXPECT_EQ(overall(0.006, 0.007).text, "none of 2 checks fails");
  EXPECT_EQ(overall(0.004, 0.007).verdict, Verdict::marginal);
  EXPECT_EQ(overall(0.004, 0.007).text, "none of 2 checks fails; little room: D, main – bay");
  EXPECT_EQ(overall(0.003, 0.004).verdict, Verdict::fail);
  EXPECT_EQ(overall(0.003, 0.004).text, "2 of 2 checks fail: D, main – bay");
  EXPECT_EQ(overallVerdict(scene_, {}, {}).verdict, Verdict::no_limits);
}

TEST_F(Verdicts, ASolvedLimitBeyondTheMeasuresOwnFails) {
  linear_.low_high = {{{9.0, 11.0}, {9.0, 24.0}}};
  EXPECT_EQ(withSigma(0.5).verdict, Verdict::pass);
  linear_.low_high[0].push_back({4.9, 10.0});
  EXPECT_EQ(withSigma(0.5).verdict, Verdict::fail);
  EXPECT_EQ(std::string(verdict().basis), "low and high");
  linear_.low_high[0].back() = {kNaN, 10.0};
  EXPECT_EQ(withSigma(0.5).verdict, Verdict::pass) << "what has no value breaks no limit";
}

}  // namespace
}  // namespace cable_variation
