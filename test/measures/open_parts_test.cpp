// Parts that are open say so in every answer that looks at them, with what their winding number tells; closed
// ones, however badly they were exported, say nothing.
#include <cable_variation/measures/open_parts.h>

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include <cable_variation/envelope/clearance/envelope_clearance.h>
#include <cable_variation/envelope/envelope_generator.h>
#include <cable_variation/sensitivity/stability_analysis.h>
#include <cable_variation/simulation/simulation.h>

#include <envelope/envelope_scenes.h>

namespace cable_variation::test {
namespace {

using Eigen::Vector3d;

constexpr double kLength = 0.06, kRadius = 0.002;

enum class Block { whole, rounded, without_a_facet, without_a_face };

// 100 mm by 50 mm by 50 mm, as drawn or as exported. x = 0.05 is its middle.
TriangleMesh block(Block kind) {
  TriangleMesh mesh = boxMesh({0.1, 0.05, 0.05});
  for (Vector3d& vertex : mesh.vertices) vertex.x() += 0.05;
  if (kind == Block::rounded) {
    // a corner of one facet beside the others'
    mesh.vertices.push_back(mesh.vertices[mesh.triangles[0][0]] + Vector3d(4e-18, 1e-17, 0.0));
    mesh.triangles[0][0] = static_cast<std::uint32_t>(mesh.vertices.size() - 1);
  }
  const auto facesEnd = [&](const std::array<std::uint32_t, 3>& triangle) {
    for (const std::uint32_t corner : triangle) {
      if (mesh.vertices[corner].x() < 0.09) return false;
    }
    return true;
  };
  const std::size_t wanted = kind == Block::without_a_face ? 2 : kind == Block::without_a_facet ? 1 : 0;
  for (std::size_t gone = 0; gone < wanted; ++gone) {
    const auto found = std::find_if(mesh.triangles.begin(), mesh.triangles.end(), facesEnd);
    if (found != mesh.triangles.end()) mesh.triangles.erase(found);
  }
  return mesh;
}

// A straight cable along x from `start`, its clip free to vary along y.
Scene sceneWith(Block kind, const Vector3d& start) {
  Scene scene = freeRod(kLength, kRadius);
  scene.harness.clips[0].pose.position = scene.clip_mounts[0].pose.position = start;
  Component part = boxPart("block", {1.0, 1.0, 1.0}, Pose());
  part.visuals[0].mesh = std::make_shared<const TriangleMesh>(block(kind));
  scene.components = {part};
  addVariable(scene, "y", ClipTranslation{0, Axis::y}, -1e-3, 1e-3);
  Measure distance = measure(Measure::Type::distance, "d");
  distance.component = 0;
  distance.unit = "m";
  scene.measures = {distance};
  return scene;
}

MeasureValue valueOf(const Scene& scene) {
  EquilibriumSolver solver;
  const Solved solved = solveAt(scene, {}, solver);
  return MeasureEvaluator(scene, solved.view()).evaluate(solved.view(), allOf(1))[0];
}

bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

std::string joinedWarnings(const std::vector<std::string>& warnings) {
  std::string all;
  for (const std::string& warning : warnings) all += warning + "\n";
  return all;
}

TEST(OpenParts, MeasuresSayWhatTheyKnow) {
  const Vector3d within(0.02, 0.0, 0.0), beside(0.02, 0.06, 0.0);
  for (const Block kind : {Block::whole, Block::rounded}) {
    const MeasureValue value = valueOf(sceneWith(kind, within));
    EXPECT_NEAR(value.value, -0.025 - kRadius, 1e-7);
    EXPECT_TRUE(
        contains(value.note,
                 "the centreline enters 'block': minus the depth of its deepest point and the radius there"))
        << value.note;
    EXPECT_FALSE(contains(value.note, "open"));
    EXPECT_FALSE(value.undecided);
    EXPECT_EQ(valueOf(sceneWith(kind, beside)).note.find("open"), std::string::npos);
  }
  const MeasureValue told = valueOf(sceneWith(Block::without_a_facet, within));
  EXPECT_NEAR(told.value, -0.025 - kRadius, 1e-7);
  EXPECT_TRUE(contains(told.note, "'block' is open, its winding number 0.9")) << told.note;
  EXPECT_FALSE(told.undecided);
  EXPECT_TRUE(contains(valueOf(sceneWith(Block::without_a_facet, beside)).note, "'block' is open"));

  // right before the hole, and through it
  const MeasureValue before = valueOf(sceneWith(Block::without_a_face, {0.105, 0.0, 0.0}));
  EXPECT_TRUE(before.undecided);
  EXPECT_TRUE(contains(before.note, "it cannot be told whether the cable is inside 'block'")) << before.note;
  EXPECT_GT(before.value, 0.0);
}

TEST(OpenParts, AnalysesWarn) {
  for (const Block kind : {Block::rounded, Block::without_a_facet}) {
    const Scene scene = sceneWith(kind, {0.02, 0.06, 0.0});
    EquilibriumSolver solver;
    const Solved solved = solveAt(scene, {}, solver);
    const MeasureEvaluator evaluator(scene, solved.view());
    const std::size_t wanted = kind == Block::rounded ? 0 : 1;
    const std::string sentence =
        "component 'block' is open: 3 edges of its surface, 171 mm in all, have no neighbour";

    const StabilityAnalysis analysis = analyseStability(scene, evaluator, {}, solver);
    EXPECT_EQ(contains(joinedWarnings(analysis.warnings), sentence), wanted > 0)
        << joinedWarnings(analysis.warnings);

    SimulationOptions simulation;
    simulation.samples = 50;
    simulation.variables = {0};
    simulation.measures = {0};
    const Simulation simulated = simulateVariation(scene, evaluator, simulation, solver);
    EXPECT_EQ(contains(joinedWarnings(simulated.warnings), sentence), wanted > 0);

    EnvelopeOptions options;
    options.variables = {0};
    options.verification = 20;
    const Envelope envelope = generateEnvelope(scene, options, solver);
    const auto found = clearances(scene, envelope, options, evaluator.parts(), solver);
    ASSERT_EQ(found.size(), 1U);
    EXPECT_EQ(openPartWarnings(found).size(), wanted);
    EXPECT_EQ(noteOf(found[0]), wanted > 0 ? "'block' is open" : "");
  }
}

// Samples at which it is not known are counted.
TEST(OpenParts, SimulationsCountWhatCannotBeTold) {
  const Scene scene = sceneWith(Block::without_a_face, {0.105, 0.0, 0.0});
  EquilibriumSolver solver;
  const Solved solved = solveAt(scene, {}, solver);
  const MeasureEvaluator evaluator(scene, solved.view());
  SimulationOptions options;
  options.samples = 50;
  options.variables = {0};
  options.measures = {0};
  const Simulation simulated = simulateVariation(scene, evaluator, options, solver);
  EXPECT_TRUE(
      contains(joinedWarnings(simulated.warnings), "in 50 equilibria it cannot be told whether a cable"))
      << joinedWarnings(simulated.warnings);
}

TEST(OpenParts, AreLookedAtOnce) {
  ComponentOpenness openness;
  Scene scene = sceneWith(Block::without_a_facet, Vector3d::Zero());
  EXPECT_EQ(openness.of(scene.components[0]).edges, 3U);
  EXPECT_EQ(openness.of(scene.components[0]).edges, 3U);
  scene = sceneWith(Block::whole, Vector3d::Zero());
  EXPECT_EQ(openness.of(scene.components[0]).edges, 0U);
  scene.components[0].visuals.clear();
  EXPECT_EQ(openness.of(scene.components[0]).edges, 0U);
}

}  // namespace
}  // namespace cable_variation::test
