// Contact in a scene file, as the design moves its parts, and in analyses that do not know it.

#include <string>

#include <gtest/gtest.h>

#include <cable_variation/scene/design.h>
#include <cable_variation/scene_file/scene_reader.h>
#include <cable_variation/scene_file/scene_writer.h>
#include <cable_variation/sensitivity/stability_analysis.h>

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
  expectRefused([&] { solver.differentiate({HarnessRate()}); }, "derivatives");
  const SolvedScene solved{scene.harness, result, componentPosesAt(scene, {})};
  const MeasureEvaluator evaluator(scene, solved);
  expectRefused([&] { analyseStability(scene, evaluator, {}, solver); }, "stability analyses");
  ASSERT_FALSE(result.contacts.empty());
  const std::vector<MeasureValue> values = evaluator.evaluate(solved, {0, 1, 2, 3});
  EXPECT_TRUE(std::isnan(values[0].value));
  EXPECT_NE(values[0].note.find("not yet known where a cable touches"), std::string::npos);
  EXPECT_TRUE(std::isnan(values[3].value));
  EXPECT_FALSE(values[3].note.empty());
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

}  // namespace
}  // namespace cable_variation
