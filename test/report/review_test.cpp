// Reports on the harness in the engine bay and on a small envelope, solved: every figure looked at is that of
// the result, in the unit of its column.
#include <cable_variation/report/review.h>

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include <cable_variation/envelope/clearance/clearance_limit.h>
#include <cable_variation/envelope/clearance/closest_solved.h>
#include <cable_variation/geometry/body/outer_surface.h>
#include <cable_variation/geometry/mesh/mesh_volume.h>
#include <cable_variation/report/design_changes.h>
#include <cable_variation/report/verdict.h>
#include <cable_variation/scene/design.h>
#include <cable_variation/scene_file/scene_reader.h>
#include <cable_variation/util/chosen_indices.h>
#include <cable_variation/util/regular_file.h>
#include <cable_variation/util/sha256.h>
#include <cable_variation/util/version.h>
#include <measures/solved_scene.h>
#include <report/page_tables.h>

#include "test_packages.h"

namespace cable_variation {
namespace {

constexpr double kFourDigits = 6e-4;  // half of the last one of 1000, and a little

void expectShown(const std::string& shown, double value) {
  if (std::isinf(value)) {
    EXPECT_EQ(number(shown), value) << shown;
    return;
  }
  EXPECT_NEAR(number(shown), value, kFourDigits * std::abs(value)) << shown;
}

/// The harness, analysed and simulated once for all tests.
struct Harnessed {
  Scene scene = readScene(findTestPackage("cable_variation") + "/config/harness.yaml", findTestPackage);
  DesignValues values;
  Harness harness = harnessAt(scene, values);
  ComponentPoses poses = componentPosesAt(scene, values);
  EquilibriumSolver solver = solverOf(scene);
  Equilibrium equilibrium = solver.solve(harness);
  SolvedScene solved{harness, equilibrium, poses};
  MeasureEvaluator evaluator{scene, solved};
  StabilityAnalysis stability = analyseStability(scene, evaluator, {}, solver);
  Simulation simulation = simulated();

  static EquilibriumSolver solverOf(const Scene& scene) {
    EquilibriumOptions options;
    options.accuracy = scene.accuracy;
    return EquilibriumSolver(options);
  }
  Simulation simulated() const {
    SimulationOptions options;
    options.variables = allIndices(scene.design_variables.size());
    options.samples = 400;
    return simulateVariation(scene, evaluator, options, solver);
  }
  Review review(const std::string& title) const {
    Review made{title,
                "2024-03-01 12:34:56 UTC",
                "A. <Engineer> & Sons",
                {},
                {},
                sha256(readWhole(scene.source, kAnySize)),
                {},
                scene,
                values,
                solved,
                stability.measures,
                stability.values,
                stability.variables,
                nullptr,
                nullptr,
                std::nullopt};
    return made;
  }
};

const Harnessed& harnessed() {
  static const Harnessed all;
  return all;
}

const std::string& stabilityPage() {
  static const std::string page = [] {
    Review review = harnessed().review("Stability analysis");
    review.stability = &harnessed().stability;
    return reviewPage(review);
  }();
  return page;
}

const std::string& simulationPage() {
  static const std::string page = [] {
    Review review = harnessed().review("Variation simulation");
    review.simulation = &harnessed().simulation;
    return reviewPage(review);
  }();
  return page;
}

std::size_t measureNamed(const Scene& scene, const std::string& name) {
  for (std::size_t i = 0; i < scene.measures.size(); ++i) {
    if (scene.measures[i].name == name) return i;
  }
  throw std::out_of_range(name);
}

TEST(Review, SaysOfWhichFileAndByWhomItIs) {
  const ReadPage page(stabilityPage());
  std::string head;
  for (const auto* each : page.all("dl")) head += textOf(*each);
  for (const std::string& text :
       {harnessed().scene.source, sha256(readWhole(harnessed().scene.source, kAnySize)),
        std::string("2024-03-01 12:34:56 UTC"), std::string("cable_variation ") + packageVersion(),
        std::string("A. <Engineer> & Sons")}) {
    EXPECT_NE(head.find(text), std::string::npos) << text << " in " << head;
  }
}

TEST(Review, LoadsNothingFromElsewhere) {
  const ReadPage page(simulationPage());
  EXPECT_TRUE(page.all("script").empty());
  EXPECT_TRUE(page.all("link").empty());
  for (const char* name : {"image", "a", "img"}) {
    for (const auto* element : page.all(name)) {
      const char* const address = element->Attribute("href");
      ASSERT_NE(address, nullptr);
      EXPECT_TRUE(std::string(address).rfind("#", 0) == 0 ||
                  std::string(address).rfind("data:image/png;base64,", 0) == 0)
          << std::string(address).substr(0, 80);
    }
  }
  EXPECT_EQ(page.all("image").size(), 1u);
  EXPECT_EQ(simulationPage().find("url("), std::string::npos);
  EXPECT_EQ(simulationPage().find("@import"), std::string::npos);
}

TEST(Review, StabilityHasTheVerdictOfEveryMeasure) {
  const StabilityAnalysis& analysis = harnessed().stability;
  const Scene& scene = harnessed().scene;
  const PageTable table = ReadPage(stabilityPage()).table({"verdict", "Cpk", "worst case"});
  ASSERT_EQ(table.rows.size(), scene.measures.size());
  std::size_t judged = 0;
  for (std::size_t i = 0; i < scene.measures.size(); ++i) {
    const Measure& measure = scene.measures[i];
    const auto row = static_cast<Eigen::Index>(i);
    const double value = analysis.values[i].value, sigma = analysis.sigma[row];
    const double unit = measure.unit == "m"     ? 1e3
                        : measure.unit == "rad" ? 180.0 / M_PI
                        : measure.unit == "1"   ? 1e2
                                                : 1.0;
    expectShown(table.cell(measure.name, "design"), unit * value);
    const std::string worst = table.cell(measure.name, "worst case");
    const std::string between = " … ";
    ASSERT_NE(worst.find(between), std::string::npos) << worst;
    EXPECT_NEAR(number(worst), unit * (value + analysis.worst_low[row]),
                kFourDigits * unit * std::abs(value + analysis.worst_low[row]) + 1e-9);
    expectShown(worst.substr(worst.find(between) + between.size()),
                unit * (value + analysis.worst_high[row]));
    if (!measure.lower && !measure.upper) {
      EXPECT_EQ(table.cell(measure.name, "verdict"), "");
      continue;
    }
    ++judged;
    const double mean = value + analysis.mean_shift[row];
    double cpk = HUGE_VAL;
    if (measure.lower) cpk = std::min(cpk, (mean - *measure.lower) / (3.0 * sigma));
    if (measure.upper) cpk = std::min(cpk, (*measure.upper - mean) / (3.0 * sigma));
    EXPECT_NEAR(number(table.cell(measure.name, "Cpk")), cpk, 6e-3 * std::abs(cpk)) << measure.name;
    const bool inside =
        !(measure.lower && value < *measure.lower) && !(measure.upper && value > *measure.upper);
    const std::string expected = !inside || cpk < 1.0 ? "✗ fail" : cpk < 1.33 ? "marginal" : "✓ pass";
    EXPECT_EQ(table.cell(measure.name, "verdict"), expected) << measure.name;
  }
  EXPECT_GE(judged, 9u);
  // The initial design of the harness is one that is to be made better, see doc/cases.md.
  EXPECT_NE(stabilityPage().find("<strong>FAIL</strong>"), std::string::npos);
}

TEST(Review, SimulationJudgesByItsOwnCpk) {
  const Simulation& simulation = harnessed().simulation;
  const Scene& scene = harnessed().scene;
  const PageTable table = ReadPage(simulationPage()).table({"verdict", "Cpk", "outside"});
  for (const char* name : {"D_CAR", "bend", "end_moment", "stiffness"}) {
    const std::size_t i = measureNamed(scene, name);
    ASSERT_TRUE(simulation.statistics.statistics[i].capability);
    const double cpk = simulation.statistics.statistics[i].capability->cpk;
    EXPECT_NEAR(number(table.cell(name, "Cpk")), cpk, 6e-3 * std::abs(cpk)) << name;
    if (cpk < 1.0) {
      EXPECT_EQ(table.cell(name, "verdict"), "✗ fail");
    }
  }
}

TEST(Review, TellsTheTolerancesThatWentIn) {
  const PageTable table = ReadPage(stabilityPage()).table({"variable", "tolerance", "distribution", "of"});
  ASSERT_EQ(table.rows.size(), harnessed().scene.design_variables.size());
  EXPECT_EQ(table.cell("main_length", "nominal"), "312");
  EXPECT_EQ(table.cell("main_length", "tolerance"), "±3");
  EXPECT_EQ(table.cell("main_length", "unit"), "mm");
  EXPECT_EQ(table.cell("main_length", "distribution"), "uniform");
  EXPECT_EQ(table.cell("main_length", "of"), "cable main, length");
  expectShown(table.cell("main_length", "σ"), 3.0 / std::sqrt(3.0));
  EXPECT_EQ(table.cell("wh_start_rx", "tolerance"), "±5");
  EXPECT_EQ(table.cell("wh_start_rx", "unit"), "deg");
  EXPECT_EQ(table.cell("wh_start_rx", "distribution"), "normal, limits at 3 σ");
  EXPECT_EQ(table.cell("wh_start_rx", "of"), "clip WH_Start about its x");
  EXPECT_EQ(table.cell("bracket_A1", "of"), "part start_bracket, locator 0");
}

TEST(Review, TellsReactionsWithTheirComponents) {
  const PageTable table = ReadPage(stabilityPage()).table({"reaction of", "Fx [N]", "|M| [N m]"});
  const Equilibrium& equilibrium = harnessed().equilibrium;
  ASSERT_EQ(table.rows.size(), 4u);  // three clips and the breakout
  for (const Reaction& each : equilibrium.clip_reactions) {
    expectShown(table.cell(each.name, "Fx [N]"), each.force.x());
    expectShown(table.cell(each.name, "|F| [N]"), each.force.norm());
    expectShown(table.cell(each.name, "Mz [N m]"), each.moment.z());
    expectShown(table.cell(each.name, "|M| [N m]"), each.moment.norm());
  }
}

TEST(Review, DrawsFourQuantitiesAlongEachCable) {
  for (const char* cable : {"main", "branch"}) {
    for (const char* what : {": section force", ": section moment", ": curvature of the centreline",
                             ": bend radius of the centreline"}) {
      EXPECT_NE(stabilityPage().find(cable + std::string(what)), std::string::npos) << cable << what;
    }
  }
  for (const char* title :
       {"force [N]", "moment [N m]", "curvature [1/m]", "bend radius [mm]", "arc length [mm]"}) {
    EXPECT_NE(stabilityPage().find(std::string(">") + title + "</text>"), std::string::npos) << title;
  }
}

TEST(Review, EditsAreToldAsPartOfTheDesign) {
  const Scene& loaded = harnessed().scene;
  EXPECT_TRUE(designChanges(loaded, loaded).empty());
  Design design{loaded, {}};
  setCableLength(design, "main", 0.315);
  moveClip(design, "WH_End", {0.003, 0.0, 0.004}, {0.0, 0.0, 0.1});
  EXPECT_EQ(designChanges(loaded, design.scene),
            (std::vector<std::string>{"length of cable main 312 → 315 mm", "clip WH_End moved by 5 mm",
                                      "clip WH_End turned by 5.73 deg"}));
}

/// The harness's envelope by two of its variables, with what is left clear.
TEST(Review, EnvelopeHasItsChapter) {
  const Harnessed& all = harnessed();
  EnvelopeOptions options;
  options.variables = {2, 3};
  options.verification = 200;
  options.frames = clearanceFrames(all.scene, options);
  const ComponentParts parts;
  ClosestSolved closest(all.scene, options, parts, all.solver);
  const Envelope envelope = generateEnvelope(all.scene, options, all.solver, {}, closest.witness());
  const std::vector<EnvelopeClearance> found =
      clearances(all.scene, envelope, options, parts, all.solver, {}, &closest);
  std::vector<const RoundedHull*> bodies;
  for (const EnvelopePiece& piece : envelope.frames.front().pieces) bodies.push_back(&piece.body);
  const OuterSurface surface = outerSurface(bodies, {});

  Review review = all.review("Tolerance envelope");
  review.variables = options.variables;
  review.envelope.emplace(
      EnvelopeFindings{options, envelope, found, surface.mesh, surface.excess, volumeWithin(surface.mesh)});
  const ReadPage page(reviewPage(review));
  const PageTable table =
      page.table({"clearance", "verdict", "envelope [mm]", "closest solved [mm]", "limit [mm]"});
  ASSERT_EQ(table.rows.size(), found.size());
  std::size_t with_limit = 0;
  for (const EnvelopeClearance& each : found) {
    const std::string name = all.scene.harness.cables[each.cable].name + " – " +
                             (each.other ? all.scene.harness.cables[*each.other].name : each.component);
    expectShown(table.cell(name, "envelope [mm]"), 1e3 * each.distance);
    expectShown(table.cell(name, "closest solved [mm]"), 1e3 * each.worst_sample);
    const std::optional<double> limit = lowerLimit(all.scene, each);
    if (!limit) continue;
    ++with_limit;
    expectShown(table.cell(name, "limit [mm]"), 1e3 * *limit);
    const std::string verdict = table.cell(name, "verdict");
    EXPECT_EQ(verdict, each.worst_sample < *limit ? "✗ fail"
                       : each.distance < *limit   ? "marginal"
                                                  : "✓ pass");
  }
  EXPECT_EQ(with_limit, 4u);  // two cables to the bay and to the engine
  EXPECT_TRUE(std::is_sorted(table.rows.begin(), table.rows.end(),
                             [](const auto& a, const auto& b) { return number(a[2]) < number(b[2]); }));
  const PageTable figures = page.table({"figure", "value", "what it is"});
  expectShown(figures.cell("volume", "value"), 1e6 * volumeWithin(surface.mesh));
  EXPECT_EQ(figures.cell("volume", "unit"), "cm³");
  const PageTable measures = page.table({"measure", "verdict", "worst case"});
  double least = HUGE_VAL;
  for (const EnvelopeClearance& each : found) {
    if (each.component == "engine_bay") least = std::min(least, each.distance);
  }
  expectShown(measures.cell("D_CAR", "worst case").substr(std::string("≥ ").size()), 1e3 * least);
}

TEST(Review, EveryTextOfTheSceneIsEscaped) {
  const std::string nasty = "<b>\"x\" & 'y' ]]>\xff\x01</b><script>alert(1)</script>";
  Scene scene = harnessed().scene;
  scene.source = "/tmp/" + nasty + ".yaml";
  for (auto& each : scene.components) each.name += nasty;
  for (auto& each : scene.harness.cables) each.name += nasty;
  for (auto& each : scene.harness.clips) each.name += nasty;
  for (auto& each : scene.harness.joints) each.name += nasty;
  for (auto& each : scene.design_variables) each.name += nasty, each.distribution = "normal";
  for (auto& each : scene.measures) each.name += nasty;
  Equilibrium equilibrium = harnessed().equilibrium;
  for (auto& each : equilibrium.clip_reactions) each.name += nasty;
  for (auto& each : equilibrium.joint_reactions) each.name += nasty;
  equilibrium.notes = {nasty};
  ComponentPoses poses;
  for (const auto& [name, pose] : harnessed().poses) poses[name + nasty] = pose;
  const SolvedScene solved{scene.harness, equilibrium, poses};
  Review review{nasty,
                nasty,
                nasty,
                {{nasty, nasty}},
                {nasty},
                nasty,
                {nasty},
                scene,
                harnessed().values,
                solved,
                harnessed().stability.measures,
                harnessed().stability.values,
                harnessed().stability.variables,
                &harnessed().stability,
                &harnessed().simulation,
                std::nullopt};
  const std::string html = reviewPage(review);
  const ReadPage page(html);
  EXPECT_TRUE(page.all("script").empty());
  EXPECT_TRUE(page.all("b").empty());
  EXPECT_EQ(html.find("<script"), std::string::npos);
  EXPECT_EQ(html.find('\xff'), std::string::npos);
  EXPECT_EQ(html.find('\x01'), std::string::npos);
}

}  // namespace
}  // namespace cable_variation
