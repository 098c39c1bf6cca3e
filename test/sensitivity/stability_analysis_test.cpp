#include <cable_variation/sensitivity/stability_analysis.h>

#include <cmath>
#include <stdexcept>
#include <string>

#include <gtest/gtest.h>

#include <equilibrium/cases.h>

namespace cable_variation::test {
namespace {

// A strand between two clamps in the world, the second of which varies.
Scene strandScene() {
  Scene scene;
  scene.accuracy = 1e-3;  // one coarse grid, so that re-solved equilibria differ by the design alone
  scene.harness = caseW();
  scene.clip_mounts.resize(scene.harness.clips.size());
  for (std::size_t i = 0; i < scene.clip_mounts.size(); ++i) {
    scene.clip_mounts[i].pose = scene.harness.clips[i].pose;
  }
  return scene;
}

void addVariable(Scene& scene, const std::string& name, const DesignTarget& target, double lower,
                 double upper, const std::string& distribution = "normal", double nominal = 0.0) {
  DesignVariable variable;
  variable.name = name;
  variable.target = target;
  variable.nominal = nominal;
  variable.lower = lower;
  variable.upper = upper;
  variable.distribution = distribution;
  if (distribution == "normal") variable.distribution_parameters["sigma"] = 3.0;
  scene.design_variables.push_back(variable);
}

void addMeasure(Scene& scene, const std::string& name, Measure::Type type, double arc_length = 0.156,
                const Eigen::Vector3d& direction = Eigen::Vector3d::UnitZ()) {
  Measure measure;
  measure.name = name;
  measure.type = type;
  measure.cables = {0};
  if (type == Measure::Type::position) {
    measure.arc_length = arc_length;
    measure.direction = direction;
  }
  if (type == Measure::Type::clip_force) measure.clip = 1;
  scene.measures.push_back(measure);
}

constexpr double kMillimetre = 1e-3;
constexpr double kDegree = M_PI / 180.0;

Scene fullScene() {
  Scene scene = strandScene();
  addVariable(scene, "x", ClipTranslation{1, Axis::x}, -kMillimetre, kMillimetre);
  addVariable(scene, "y", ClipTranslation{1, Axis::y}, -kMillimetre, 2.0 * kMillimetre, "uniform");
  addVariable(scene, "turn", ClipRotation{1, Axis::z}, -2.0 * kDegree, 2.0 * kDegree);
  addVariable(scene, "length", CableProperty{0, CableProperty::Property::length}, -kMillimetre, kMillimetre,
              "normal", scene.harness.cables[0].length);
  addMeasure(scene, "height", Measure::Type::position);
  addMeasure(scene, "end", Measure::Type::position, scene.harness.cables[0].length,
             scene.harness.clips[1].pose.orientation * Eigen::Vector3d::UnitX());
  addMeasure(scene, "force", Measure::Type::clip_force);
  addMeasure(scene, "shape", Measure::Type::similarity);
  addMeasure(scene, "softest", Measure::Type::eigenvalue);
  return scene;
}

EquilibriumSolver solverFor(const Scene& scene) {
  EquilibriumOptions options;
  options.accuracy = scene.accuracy;
  return EquilibriumSolver(options);
}

StabilityAnalysis analysed(const Scene& scene, const StabilityOptions& options = {}) {
  EquilibriumSolver solver = solverFor(scene);
  const Equilibrium nominal = solver.solve(scene.harness);
  const ComponentPoses components = componentPosesAt(scene, {});
  const MeasureEvaluator evaluator(scene, {scene.harness, nominal, components});
  return analyseStability(scene, evaluator, options, solver);
}

// The measures at other values of the variables, solved anew.
std::vector<double> measured(const Scene& scene, const DesignValues& values) {
  EquilibriumSolver solver = solverFor(scene);
  const Equilibrium nominal = solver.solve(scene.harness);
  const Harness harness = harnessAt(scene, values);
  const Equilibrium found = solver.update(harness);
  const ComponentPoses components = componentPosesAt(scene, values);
  const MeasureEvaluator evaluator(scene, {scene.harness, nominal, components});
  std::vector<std::size_t> all;
  for (std::size_t i = 0; i < scene.measures.size(); ++i) all.push_back(i);
  std::vector<double> figures;
  for (const MeasureValue& value : evaluator.evaluate({harness, found, components}, all)) {
    figures.push_back(value.value);
  }
  return figures;
}

TEST(StabilityAnalysis, JacobianIsTheSlopeOfResolvedMeasures) {
  const Scene scene = fullScene();
  const StabilityAnalysis analysis = analysed(scene);
  ASSERT_TRUE(analysis.nominal.converged());
  for (std::size_t column = 0; column < scene.design_variables.size(); ++column) {
    const DesignVariable& variable = scene.design_variables[column];
    const double step = 0.1 * variable.upper;
    const auto at = [&](double deviation) {
      return measured(scene, {{variable.name, variable.nominal + deviation}});
    };
    const auto a = at(step), b = at(-step), c = at(2 * step), d = at(-2 * step);
    for (std::size_t row = 0; row < scene.measures.size(); ++row) {
      const double rate =
          analysis.jacobian(static_cast<Eigen::Index>(row), static_cast<Eigen::Index>(column));
      if (analysis.one_sided[row]) {
        // the limit, extrapolated from two steps to either side
        EXPECT_NEAR(rate, (2.0 * a[row] - 0.5 * c[row]) / step, 1e-3 * rate) << variable.name;
        EXPECT_NEAR(rate, (2.0 * b[row] - 0.5 * d[row]) / step, 1e-3 * rate) << variable.name;
        continue;
      }
      const double slope = (8.0 * (a[row] - b[row]) - (c[row] - d[row])) / (12.0 * step);
      const double largest = analysis.jacobian.row(static_cast<Eigen::Index>(row)).cwiseAbs().maxCoeff();
      EXPECT_NEAR(rate, slope, 1e-5 * largest) << scene.measures[row].name << " by " << variable.name;
    }
  }
}

TEST(StabilityAnalysis, AMeasureThatIsAVariableHasItsFigures) {
  // the end's position along the clamp's x axis is the variable x itself
  const StabilityAnalysis analysis = analysed(fullScene());
  const Eigen::Index end = 1;
  EXPECT_NEAR(analysis.jacobian(end, 0), 1.0, 1e-9);
  EXPECT_NEAR(analysis.jacobian(end, 1), 0.0, 1e-9);
  EXPECT_NEAR(analysis.sigma[end], kMillimetre / 3.0, 1e-12);
  EXPECT_NEAR(analysis.contribution(end, 0), 1.0, 1e-9);
  EXPECT_NEAR(analysis.worst_low[end], -kMillimetre, 1e-10);
  EXPECT_NEAR(analysis.worst_high[end], kMillimetre, 1e-10);
  EXPECT_NEAR(analysis.mean_shift[end], 0.0, 1e-10);
  EXPECT_NEAR(analysis.low_high[1][0].low - analysis.values[1].value, -kMillimetre, 1e-9);
  EXPECT_NEAR(analysis.low_high[1][0].high - analysis.values[1].value, kMillimetre, 1e-9);
}

TEST(StabilityAnalysis, SpreadsAddAsIndependentOnesDo) {
  const Scene scene = fullScene();
  const StabilityAnalysis analysis = analysed(scene);
  // a third of 1 mm; 3 mm wide and even: 3/√12 mm, its mean off the nominal by 0.5 mm
  const Eigen::Vector4d sigma(kMillimetre / 3.0, 3.0 * kMillimetre / std::sqrt(12.0), 2.0 * kDegree / 3.0,
                              kMillimetre / 3.0);
  EXPECT_TRUE(analysis.variable_sigma.isApprox(sigma, 1e-12));
  for (Eigen::Index row = 0; row < analysis.jacobian.rows(); ++row) {
    const Eigen::VectorXd parts = analysis.jacobian.row(row).transpose().cwiseProduct(sigma);
    EXPECT_NEAR(analysis.sigma[row], parts.norm(), 1e-12 * parts.norm());
    EXPECT_NEAR(analysis.contribution.row(row).sum(), 1.0, 1e-12);
    EXPECT_NEAR(analysis.mean_shift[row], 0.5 * kMillimetre * analysis.jacobian(row, 1), 1e-12);
  }
}

TEST(StabilityAnalysis, CorrelationCountsInTheSpread) {
  Scene scene = fullScene();
  const StabilityAnalysis apart = analysed(scene);
  scene.correlations = {{0, 2, 0.8}};
  const StabilityAnalysis together = analysed(scene);
  for (Eigen::Index row = 0; row < apart.jacobian.rows(); ++row) {
    const double a = apart.jacobian(row, 0) * apart.variable_sigma[0];
    const double b = apart.jacobian(row, 2) * apart.variable_sigma[2];
    const double variance = apart.sigma[row] * apart.sigma[row] + 2.0 * 0.8 * a * b;
    EXPECT_NEAR(together.sigma[row] * together.sigma[row], variance, 1e-9 * variance);
  }
}

TEST(StabilityAnalysis, WorstCaseIsAtTheCornersAndARegionHasNone) {
  Scene scene = fullScene();
  const StabilityAnalysis box = analysed(scene);
  for (Eigen::Index row = 0; row < box.jacobian.rows(); ++row) {
    double low = 0.0, high = 0.0;
    for (Eigen::Index column = 0; column < box.jacobian.cols(); ++column) {
      const DesignVariable& variable = scene.design_variables[static_cast<std::size_t>(column)];
      const double at_low = box.jacobian(row, column) * variable.lower;
      const double at_high = box.jacobian(row, column) * variable.upper;
      low += std::min(at_low, at_high);
      high += std::max(at_low, at_high);
    }
    const bool one_sided = box.one_sided[static_cast<std::size_t>(row)];
    EXPECT_NEAR(box.worst_high[row], one_sided ? std::max(-low, high) : high, 1e-12 * std::abs(high));
    EXPECT_NEAR(box.worst_low[row], one_sided ? 0.0 : low, 1e-12 * std::abs(low));
  }
  Scene disc = strandScene();
  addVariable(disc, "x", ClipTranslation{1, Axis::x}, -kMillimetre, kMillimetre, "disc");
  addVariable(disc, "y", ClipTranslation{1, Axis::y}, -kMillimetre, kMillimetre, "disc");
  disc.tolerance_regions = {{"tip", ToleranceRegion::Shape::disc, {0, 1}, kMillimetre, true, 3.0}};
  disc.measures = {scene.measures[0]};
  const StabilityAnalysis round = analysed(disc);
  const double steepest = round.jacobian.row(0).norm();
  EXPECT_NEAR(round.worst_high[0], kMillimetre * steepest, 1e-12);
  EXPECT_NEAR(round.sigma[0], 0.5 * kMillimetre * steepest, 1e-12);  // evenly over a disc: r/2 along any line
}

TEST(StabilityAnalysis, LowAndHighAreResolved) {
  const Scene scene = fullScene();
  const StabilityAnalysis analysis = analysed(scene);
  for (std::size_t column = 0; column < scene.design_variables.size(); ++column) {
    const DesignVariable& variable = scene.design_variables[column];
    const std::vector<double> low = measured(scene, {{variable.name, variable.nominal + variable.lower}});
    const std::vector<double> high = measured(scene, {{variable.name, variable.nominal + variable.upper}});
    for (std::size_t row = 0; row < scene.measures.size(); ++row) {
      const double size = std::abs(low[row]) + std::abs(high[row]);
      EXPECT_NEAR(analysis.low_high[row][column].low, low[row], 1e-6 * size);
      EXPECT_NEAR(analysis.low_high[row][column].high, high[row], 1e-6 * size);
    }
    EXPECT_NEAR(analysis.eigenvalue_low[column], low.back(), 1e-6 * low.back());
    EXPECT_NEAR(analysis.eigenvalue_high[column], high.back(), 1e-6 * high.back());
  }
  StabilityOptions options;
  options.low_high = false;
  EXPECT_TRUE(analysed(scene, options).low_high.empty());
}

// A straight rod buckles when its ends come closer by (2π)² EI/(EA L) of its length: 3.9e-4 m here.
TEST(StabilityAnalysis, WarnsOfANominalCloseToLosingItsStability) {
  Scene scene;
  scene.accuracy = 1e-3;
  const double shortening = 4.0 * M_PI * M_PI * 1e-5;
  scene.harness = clamped(uniformCable(1.0, roundSection(1e5, 1e6, 1.0, 1.0)),
                          poseAt(1.0 - 0.5 * shortening, 0.0, 0.0), Eigen::Vector3d::Zero());
  scene.clip_mounts.resize(2);
  scene.clip_mounts[1].pose = scene.harness.clips[1].pose;
  addVariable(scene, "gap", ClipTranslation{1, Axis::x}, -0.4 * shortening, 0.4 * shortening);
  const StabilityAnalysis close = analysed(scene);
  ASSERT_TRUE(close.nominal.converged()) << close.nominal.message;
  ASSERT_FALSE(close.warnings.empty());
  EXPECT_NE(close.warnings.front().find("gap"), std::string::npos) << close.warnings.front();
  EXPECT_NE(close.warnings.front().find("stability"), std::string::npos) << close.warnings.front();

  scene.design_variables[0].lower *= 0.1;
  scene.design_variables[0].upper *= 0.1;
  EXPECT_TRUE(analysed(scene).warnings.empty());
}

// The bend radius of a straight rod is infinite: what would follow from derivatives is not defined, and said
// so; of the others all is there.
TEST(StabilityAnalysis, WhatIsNotDefinedIsSaid) {
  Scene scene;
  scene.accuracy = 1e-3;
  scene.harness = cantilever(uniformCable(0.2, roundSection(1e4, 4e3, 0.1, 0.1)), Eigen::Vector3d::Zero());
  scene.clip_mounts.resize(1);
  addVariable(scene, "turn", ClipRotation{0, Axis::y}, -0.1, 0.1);
  Measure bend, tip;
  bend.name = "bend";
  bend.type = Measure::Type::bend_radius;
  tip.name = "tip";
  tip.type = Measure::Type::position;
  bend.cables = tip.cables = {0};
  tip.arc_length = 0.2;
  tip.direction = Eigen::Vector3d::UnitZ();
  scene.measures = {bend, tip};
  const StabilityAnalysis analysis = analysed(scene);
  ASSERT_EQ(analysis.undefined.size(), 2u);
  EXPECT_EQ(analysis.undefined[0], "the value is infinite at the nominal design (straight everywhere)");
  EXPECT_EQ(analysis.undefined[1], "");
  for (const double figure : {analysis.jacobian(0, 0), analysis.sigma[0], analysis.mean_shift[0],
                              analysis.worst_low[0], analysis.worst_high[0], analysis.contribution(0, 0)})
    EXPECT_TRUE(std::isnan(figure));
  EXPECT_NEAR(analysis.jacobian(1, 0), -0.2, 1e-6);
  EXPECT_NEAR(analysis.contribution(1, 0), 1.0, 1e-12);
  EXPECT_EQ(analysis.coupling, Coupling::uncoupled);
  ASSERT_FALSE(analysis.warnings.empty());
  EXPECT_EQ(analysis.warnings.back(),
            "bend: derivatives and spread are not defined: " + analysis.undefined[0]);
}

TEST(StabilityAnalysis, AnotherDesignIsAnalysedAsItsOwnNominal) {
  const Scene scene = fullScene();
  StabilityOptions options;
  options.values = {{"turn", 3.0 * kDegree}};
  const StabilityAnalysis analysis = analysed(scene, options);
  EXPECT_NEAR(analysis.values[3].value, 0.0, 1e-9);  // similarity is to the design analysed
  const std::vector<double> there = measured(scene, options.values);
  EXPECT_NEAR(analysis.values[0].value, there[0], 1e-9);
  const std::vector<double> high = measured(scene, {{"turn", 5.0 * kDegree}});
  EXPECT_NEAR(analysis.low_high[0][2].high, high[0], 1e-8);
}

TEST(StabilityAnalysis, ChosenVariablesAndMeasuresOnly) {
  const Scene scene = fullScene();
  StabilityOptions options;
  options.variables = {2};
  options.measures = {2, 0};
  const StabilityAnalysis some = analysed(scene, options), all = analysed(scene);
  ASSERT_EQ(some.jacobian.rows(), 2);
  ASSERT_EQ(some.jacobian.cols(), 1);
  EXPECT_NEAR(some.jacobian(0, 0), all.jacobian(2, 2), 1e-9 * std::abs(all.jacobian(2, 2)));
  EXPECT_NEAR(some.jacobian(1, 0), all.jacobian(0, 2), 1e-9 * std::abs(all.jacobian(0, 2)));
  options.variables = {7};
  EXPECT_THROW(analysed(scene, options), std::invalid_argument);
}

TEST(StabilityAnalysis, WithoutAnEquilibriumThereIsNothingElse) {
  const Scene scene = fullScene();
  StabilityOptions options;
  options.values = {{"x", 0.5}};  // half a metre away
  const StabilityAnalysis analysis = analysed(scene, options);
  EXPECT_EQ(analysis.nominal.status, EquilibriumStatus::impossible);
  EXPECT_EQ(analysis.jacobian.size(), 0);
}

}  // namespace
}  // namespace cable_variation::test
