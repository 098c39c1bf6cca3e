// Contact in a scene file, as the design moves its parts, and in analyses that do not know it.

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include <cable_variation/scene/design.h>
#include <cable_variation/scene_file/scene_reader.h>
#include <cable_variation/scene_file/scene_writer.h>
#include <cable_variation/sensitivity/stability_analysis.h>
#include <cable_variation/simulation/simulation.h>

#include "test_packages.h"

namespace cable_variation {
namespace {

// A wire held above a tetrahedron of 100 mm, whose corner is at its component's origin.
const std::string kScene = R"(components:
  - {name: carrier}
  - {name: block, parent: carrier, mesh: package://test_data/meshes/tetrahedron.stl, scale: 0.1, pose: {position: [0.1, -0.02, -0.11]}}
cables:
  - {name: wire, length: 400 mm, stiffness: {EA: 1e4, GA: 4e3, EI: 1e-2, GJ: 8e-3, mass_per_length: 0.1, radius: 3 mm}}
clips:
  - {name: A, type: fixed, cable: wire, at: start, pose: {position: [0, 0, 0], x_axis: [1, 0, 0]}}
  - {name: B, type: fixed, cable: wire, at: end, component: block, pose: {position: [0.28, 0.02, 0.11]}}
contact:
  - {cables: [wire], with: [block], stand_off: 0.5 mm, skip_near_clips: 20 mm}
design_variables:
  - {name: rise, component: block, translate: z, tolerance: 5 mm}
measures:
  - {name: force, type: section_force, cable: wire, at: 100 mm}
  - {name: pressed, type: contact_force, component: block}
  - {name: lying, type: contact_length, cable: wire, component: block}
  - {name: firmness, type: eigenvalue}
)";

Scene read() { return readSceneText(kScene, "scene.yaml", findTestPackage); }

TEST(SceneContact, IsRead) {
  const Scene scene = read();
  ASSERT_EQ(scene.contacts.size(), 1U);
  ASSERT_EQ(scene.harness.contacts.size(), 1U);
  const PartContact& contact = scene.harness.contacts[0];
  EXPECT_EQ(contact.part, "block");
  EXPECT_EQ(contact.cable, 0U);
  EXPECT_DOUBLE_EQ(contact.stand_off, 5e-4);
  EXPECT_DOUBLE_EQ(contact.skip_near_clips, 0.02);
  EXPECT_EQ(contact.own_clips, std::vector<std::size_t>{1});
  EXPECT_LT((contact.pose.position - Eigen::Vector3d(0.1, -0.02, -0.11)).norm(), 1e-12);
}

TEST(SceneContact, FollowsItsPart) {
  const Scene scene = read();
  const Harness raised = harnessAt(scene, {{"rise", 0.004}});
  EXPECT_NEAR(raised.contacts[0].pose.position.z(), -0.106, 1e-12);
  const Harness moved =
      harnessAt(scene, {}, {{"carrier", {{0.0, 0.5, 0.0}, Eigen::Quaterniond::Identity()}}});
  EXPECT_NEAR(moved.contacts[0].pose.position.y(), 0.48, 1e-12);
}

TEST(SceneContact, StaysInAnEditedFile) {
  Design design{read(), {}};
  setCableLength(design, "wire", 0.41);
  const std::string text = editedSceneText(kScene, read(), sceneOf(design));
  const Scene again = readSceneText(text, "saved.yaml", findTestPackage);
  EXPECT_NO_THROW(requireSame(again, sceneOf(design)));
  EXPECT_EQ(again.harness.contacts.size(), 1U);
}

template <class Call>
void expectRefused(const Call& call, const std::string& what) {
  try {
    call();
    ADD_FAILURE() << what << " are not refused";
  } catch (const std::invalid_argument& error) {
    EXPECT_NE(std::string(error.what()).find("contact is not yet known to " + what), std::string::npos)
        << error.what();
  }
}

TEST(SceneContact, IsRefusedByNameWhereItIsNotKnown) {
  const Scene scene = read();
  EquilibriumSolver solver;
  const Equilibrium result = solver.solve(scene.harness);
  ASSERT_TRUE(result.converged()) << result.message;
  expectRefused([&] { solver.eigenvalueRates({HarnessRate()}); }, "derivatives of the smallest eigenvalue");
  const SolvedScene solved{scene.harness, result, componentPosesAt(scene, {})};
  const MeasureEvaluator evaluator(scene, solved);
  ASSERT_FALSE(result.contacts.empty());
  const std::vector<MeasureValue> values = evaluator.evaluate(solved, {0, 1, 2, 3});
  EXPECT_TRUE(std::isnan(values[0].value));
  EXPECT_NE(values[0].note.find("not yet known where a cable touches"), std::string::npos);
  EXPECT_FALSE(values[3].value <= 0.0);
  double total = 0.0, length = 0.0;
  for (const ContactInterval& interval : result.contacts) {
    total += interval.total;
    length += interval.end - interval.start;
  }
  EXPECT_DOUBLE_EQ(values[1].value, total);
  EXPECT_DOUBLE_EQ(values[2].value, length);
  EXPECT_TRUE(values[1].has_place);
  EXPECT_GE(values[1].arc_length, result.contacts.front().start);
  EXPECT_LE(values[1].arc_length, result.contacts.back().end);
  Harness loaded = scene.harness;
  loaded.loads.push_back({"turn", 0, 0.2, Eigen::Vector3d::Zero(), Eigen::Vector3d(0.0, 0.1, 0.0)});
  expectRefused([&] { solver.solve(loaded); }, "dead moments");
}

StabilityAnalysis analyse(const Scene& scene, const StabilityOptions& options = {}) {
  EquilibriumSolver solver;
  const Harness harness = harnessAt(scene, {});
  const Equilibrium nominal = solver.solve(harness);
  EXPECT_TRUE(nominal.converged()) << nominal.message;
  const ComponentPoses components = componentPosesAt(scene, {});
  const MeasureEvaluator evaluator(scene, {harness, nominal, components});
  return analyseStability(scene, evaluator, options, solver);
}

bool isToldOf(const std::vector<std::string>& warnings, const std::string& what) {
  return std::any_of(warnings.begin(), warnings.end(),
                     [&](const std::string& warning) { return warning.find(what) != std::string::npos; });
}

// The block and the clip on it rise together: what is pressed changes as re-solved designs say.
TEST(SceneContact, StabilityIsAnalysed) {
  const Scene scene = read();
  const StabilityAnalysis analysis = analyse(scene);
  ASSERT_TRUE(analysis.nominal.converged());
  ASSERT_FALSE(analysis.nominal.contacts.empty());
  EXPECT_EQ(analysis.undefined[0].substr(0, 12), "the nominal ");
  EXPECT_TRUE(analysis.undefined[1].empty()) << analysis.undefined[1];
  EXPECT_NE(analysis.undefined[2].find("in steps"), std::string::npos) << analysis.undefined[2];
  EXPECT_NE(analysis.undefined[3].find("not yet known where a cable touches"), std::string::npos)
      << analysis.undefined[3];
  constexpr double kStep = 1e-4;
  double pressed[2];
  for (const int side : {0, 1}) {
    EquilibriumSolver solver;
    ASSERT_TRUE(solver.solve(harnessAt(scene, {})).converged());
    const Equilibrium there = solver.update(harnessAt(scene, {{"rise", side == 0 ? -kStep : kStep}}));
    ASSERT_TRUE(there.converged()) << there.message;
    pressed[side] = 0.0;
    for (const ContactInterval& interval : there.contacts) pressed[side] += interval.total;
  }
  const double slope = (pressed[1] - pressed[0]) / (2.0 * kStep);
  EXPECT_GT(std::abs(slope), 1.0);
  EXPECT_NEAR(analysis.jacobian(1, 0), slope, 2e-2 * std::abs(slope));
  ASSERT_EQ(analysis.low_high.size(), 4U);
  EXPECT_TRUE(std::isfinite(analysis.low_high[2][0].low));
}

// A tolerance that takes the part away, or the cable to it, is told with its variable.
TEST(SceneContact, StabilityTellsWhereATouchBeginsOrEnds) {
  Scene scene = read();
  scene.design_variables[0].lower = -0.06;
  scene.design_variables[0].upper = 0.001;
  scene.clip_mounts[1] = {"world", harnessAt(scene, {}).clips[1].pose};
  const StabilityAnalysis touching = analyse(scene);
  ASSERT_FALSE(touching.nominal.contacts.empty());
  EXPECT_TRUE(isToldOf(touching.warnings, "takes all of the"));
  EXPECT_TRUE(isToldOf(touching.warnings, "rise at its lower limit has taken cable 'wire' off part 'block'"));
  scene.components[1].pose.position.z() -= 0.06;
  scene.design_variables[0].lower = -0.001;
  scene.design_variables[0].upper = 0.06;
  const StabilityAnalysis clear = analyse(scene);
  ASSERT_TRUE(clear.nominal.contacts.empty());
  EXPECT_FALSE(isToldOf(clear.warnings, "takes all of the"));
  EXPECT_TRUE(
      isToldOf(clear.warnings, "rise at its upper limit has brought cable 'wire' to touch part 'block'"));
}

// Production of a cable that touches: every sample is followed by itself, the same whatever the threads.
TEST(SceneContact, VariationIsSimulated) {
  const Scene scene = read();
  EquilibriumSolver solver;
  const Harness harness = harnessAt(scene, {});
  const Equilibrium nominal = solver.solve(harness);
  ASSERT_TRUE(nominal.converged()) << nominal.message;
  const ComponentPoses components = componentPosesAt(scene, {});
  const MeasureEvaluator evaluator(scene, {harness, nominal, components});
  SimulationOptions options;
  options.variables = {0};
  options.measures = {1};
  options.samples = 40;
  std::vector<std::vector<double>> runs;
  for (const int threads : {1, 2}) {
    options.threads = threads;
    runs.emplace_back();
    const Simulation simulation = simulateVariation(
        scene, evaluator, options, solver,
        [&](std::uint64_t index, SampleOutcome outcome, const double* deviations, const double* values) {
          EXPECT_EQ(outcome, SampleOutcome::solved) << index;
          if (values == nullptr) return;
          runs.back().insert(runs.back().end(), {deviations[0], values[0]});
          // each by itself from the design
          if (index % 10 != 0) return;
          EquilibriumSolver one = solver;
          const Equilibrium there =
              one.update(harnessAt(scene, {{"rise", scene.design_variables[0].nominal + deviations[0]}}));
          ASSERT_TRUE(there.converged()) << there.message;
          double total = 0.0;
          for (const ContactInterval& interval : there.contacts) total += interval.total;
          EXPECT_NEAR(values[0], total, 1e-3 * total);
        });
    EXPECT_EQ(simulation.statistics.samples, 40U);
    EXPECT_EQ(simulation.solved_again, 40U);
  }
  ASSERT_EQ(runs[0].size(), 80U);
  EXPECT_EQ(runs[0], runs[1]);
}

}  // namespace
}  // namespace cable_variation
