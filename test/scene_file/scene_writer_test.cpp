// The text of a scene after edits: it reads as the edited design, solves to its shape, and is otherwise as it
// was.
#include <cable_variation/scene_file/scene_writer.h>

#include <cmath>
#include <random>
#include <string>

#include <gtest/gtest.h>

#include <cable_variation/equilibrium/equilibrium.h>
#include <cable_variation/rod/section.h>
#include <cable_variation/scene/added_cable.h>
#include <cable_variation/scene/design.h>
#include <cable_variation/scene_file/scene_reader.h>

#include "test_packages.h"

namespace cable_variation {
namespace {

std::string pathOf(const std::string& scene) {
  const std::string package = scene == "everything" ? "test_data" : "cable_variation";
  return findTestPackage(package) + (package == "test_data" ? "/scenes/" : "/config/") + scene + ".yaml";
}

std::string savedText(const std::string& text, const Design& design) {
  return editedSceneText(text, readSceneText(text, "scene.yaml", findTestPackage), sceneOf(design));
}

/// Read again, and the same as the design.
Scene saved(const std::string& text, const Design& design) {
  Scene scene = readSceneText(savedText(text, design), "saved.yaml", findTestPackage);
  requireSame(scene, sceneOf(design));
  return scene;
}

Design designOf(const std::string& text) { return {readSceneText(text, "scene.yaml", findTestPackage), {}}; }

/// Every variable anywhere in its tolerance.
void vary(Design& design, std::mt19937& random) {
  for (const DesignVariable& variable : std::vector<DesignVariable>(design.scene.design_variables)) {
    const double deviation = std::uniform_real_distribution<>(variable.lower, variable.upper)(random);
    setNominal(design, variable.name, variable.nominal + deviation);
  }
}

// A small scene of which each value may be asked for.
const std::string kScene = R"(# two parts
components:
  - name: a       # the first
    pose: {position: [1 cm, 0, 0]}   # in the world
  - {name: b, parent: a}
cables:
  - {name: wire, length: 312 mm, stiffness: {EA: 1e3, GA: 500, EI: 1e-2, GJ: 8e-3, mass_per_length: 0.1, radius: 3 mm}}
clips:
  - name: A       # holds
    type: fixed
    cable: wire
    at: start
    component: b
    pose:
      position: [0, 0, 0]   # here
      x_axis: [1, 0, 0]
  # the end
  - {name: B, type: fixed, cable: wire, at: end, pose: {position: ["250 mm", 0, 0]}}
design_variables:
  - {name: b_x, clip: B, translate: x, tolerance: 5 mm}
  - {name: wire_length, cable: wire, property: length, tolerance: 5 mm}
)";

class ShippedScene : public testing::TestWithParam<const char*> {};

TEST_P(ShippedScene, ReadsAndSolvesAsTheDesignThatWasSaved) {
  const std::string path = pathOf(GetParam());
  const std::string text = readSceneFile(path);
  std::mt19937 random(7);
  for (int trial = 0; trial < 5; ++trial) {
    Design design{readScene(path, findTestPackage), {}};
    vary(design, random);
    const Scene scene = saved(text, design);
    EquilibriumOptions options;
    options.accuracy = scene.accuracy;
    const Equilibrium wanted = EquilibriumSolver(options).solve(harnessAt(design, {}));
    const Equilibrium found = EquilibriumSolver(options).solve(scene.harness);
    ASSERT_TRUE(wanted.converged() && found.converged());
    for (std::size_t i = 0; i < wanted.shapes.size(); ++i) {
      const CableShape &a = wanted.shapes[i], &b = found.shapes[i];
      ASSERT_EQ(a.points.size(), b.points.size());
      for (std::size_t k = 0; k < a.points.size(); ++k)
        EXPECT_LT((a.points[k].pose.position - b.points[k].pose.position).norm(), 1e-6)
            << GetParam() << ", trial " << trial;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(SceneWriter, ShippedScene,
                         testing::Values("harness", "harness_clipped", "hose", "rear_lamp"));

TEST(SceneWriter, WritesAllThatADesignVariableCanChange) {
  const std::string text = readSceneFile(pathOf("everything"));
  std::mt19937 random(3);
  for (int trial = 0; trial < 20; ++trial) {
    Design design = designOf(text);
    vary(design, random);
    EXPECT_NO_THROW(saved(text, design)) << "trial " << trial;
  }
}

TEST(SceneWriter, ADesignThatWasNotEditedIsTheSameText) {
  for (const char* scene : {"harness", "harness_clipped", "hose", "rear_lamp", "everything"}) {
    const std::string text = readSceneFile(pathOf(scene));
    EXPECT_EQ(savedText(text, designOf(text)), text) << scene;
  }
}

// Text with one place of it replaced.
std::string with(std::string text, const std::string& before, const std::string& after) {
  const std::size_t at = text.find(before);
  EXPECT_NE(at, std::string::npos) << before;
  return text.replace(at, before.size(), after);
}

TEST(SceneWriter, OnlyWhatHasChangedIsWrittenAndInItsUnit) {
  Design design = designOf(kScene);
  setNominal(design, "b_x", 0.0025);
  EXPECT_EQ(savedText(kScene, design), with(kScene, "[\"250 mm\", 0, 0]", "[252.5 mm, 0, 0]"));
  design = designOf(kScene);
  setNominal(design, "wire_length", 0.315);
  EXPECT_EQ(savedText(kScene, design), with(kScene, "312 mm", "315 mm"));
  design = designOf(kScene);
  moveClip(design, "A", {0.0, 0.001, 0.0}, {0.0, 0.0, 0.0});
  EXPECT_EQ(savedText(kScene, design), with(kScene, "[0, 0, 0]   # here", "[0, 1 mm, 0]   # here"));
  design = designOf(kScene);
  moveClip(design, "A", {0.0, 0.0, 0.0}, {0.0, 0.0, 0.1});
  EXPECT_EQ(saved(kScene, design).clip_mounts[0].component, "b");
  design = designOf(kScene);
  setComponentPose(design, "b", {{0.0, 0.02, 0.0}, Eigen::Quaterniond::Identity()});
  EXPECT_EQ(savedText(kScene, design), with(kScene, "name: b,", "name: b, pose: {position: [0, 20 mm, 0]},"));
}

TEST(SceneWriter, AClipThatWasAddedStandsBehindTheOthers) {
  Design design = designOf(kScene);
  Clip clip;
  clip.name = "C";
  clip.type = "eyelet";
  clip.arc_length = 0.1;
  addClip(design, clip, {"a", {{0.1, 0.0, -0.05}, Eigen::Quaterniond::Identity()}});
  EXPECT_EQ(
      savedText(kScene, design),
      with(
          kScene, "0, 0]}}\ndesign",
          "0, 0]}}\n  - {name: C, type: eyelet, cable: wire, at: 100 mm, component: a, pose: {position: [100 "
          "mm, 0, -50 mm]}}\ndesign"));
  EXPECT_EQ(saved(kScene, design).harness.clips[2].name, "C");
}

/// With a cable and the two clips that hold it.
Design withCable(const std::string& text, const std::string& component) {
  Design design = designOf(text);
  Cable cable;
  cable.name = "added";
  cable.length = 0.2;
  cable.sections = {{0.0, solidSection(4e-3, {1e8, 0.25, 2000.0})}};
  addCable(design, cable);
  for (const double at : {0.0, cable.length}) {
    Clip clip;
    clip.name = at == 0.0 ? "one" : "other";
    clip.type = "fixed";
    clip.cable = design.scene.harness.cables.size() - 1;
    clip.arc_length = at;
    Pose pose;
    pose.position = {0.9 * at, 0.01, 0.0};
    addClip(design, clip, {component, pose});
  }
  return design;
}

TEST(SceneWriter, ACableThatWasAddedStandsBehindTheOthersOrInAListOfItsOwn) {
  for (const std::string& text :
       {kScene, std::string("components:\n  - {name: a}   # alone\n"),
        std::string("components:\n  - {name: a}"),
        std::string("components: [{name: a}]\ncables: []\nclips: []   # none yet\n"),
        std::string("{components: [{name: a}]}\n")}) {
    const Design design = withCable(text, "a");
    const Scene scene = saved(text, design);
    EXPECT_EQ(scene.harness.cables.back().name, "added");
    EXPECT_EQ(scene.clip_mounts.back().component, "a");
    EquilibriumSolver solver;
    const Equilibrium wanted = solver.solve(sceneOf(design).harness), found = solver.solve(scene.harness);
    ASSERT_TRUE(wanted.converged() && found.converged()) << text;
    EXPECT_LT((wanted.shapes.back().position(0.1) - found.shapes.back().position(0.1)).norm(), 1e-6);
    EXPECT_EQ(savedText(text, design).find(text.substr(0, 20)), 0U) << "all else is as it was";
  }
  EXPECT_NE(savedText(kScene, withCable(kScene, "world")).find("# holds"), std::string::npos);
}

TEST(SceneWriter, ACableThatIsThereOrIsNoneIsNotAdded) {
  Design design = designOf(kScene);
  EXPECT_THROW(addCable(design, design.scene.harness.cables.front()), std::invalid_argument);
  EXPECT_THROW(addCable(design, Cable()), std::invalid_argument);
}

TEST(SceneWriter, AClipThatWasOpenedOrClosedSaysSo) {
  std::string held = kScene;
  const std::string end = "pose: {position: [\"250 mm\", 0, 0]}}";
  held.replace(held.find(end), end.size(), end.substr(0, end.size() - 1) + ", attached: true}");
  for (const std::string& text : {kScene, held}) {
    Design design = designOf(text);
    setAttached(design, "B", false);
    const std::string opened = savedText(text, design);
    EXPECT_FALSE(saved(text, design).harness.clips[1].attached) << opened;

    Design again = designOf(opened);
    setAttached(again, "B", true);
    EXPECT_TRUE(saved(opened, again).harness.clips[1].attached) << savedText(opened, again);
  }
}

TEST(SceneWriter, AnAliasOfWhatHasChangedIsToldOf) {
  const std::string shared = with(kScene, "[0, 0, 0]   # here", "&zero [0, 0, 0]");
  Design design = designOf(with(shared, "[\"250 mm\", 0, 0]", "*zero"));
  const std::string original = with(shared, "[\"250 mm\", 0, 0]", "*zero");
  setNominal(design, "b_x", 0.002);  // the alias itself is replaced
  EXPECT_NO_THROW(saved(original, design));
  design = designOf(original);
  moveClip(design, "A", {0.0, 0.001, 0.0}, {0.0, 0.0, 0.0});  // what it stands for is not only this clip's
  try {
    saved(original, design);
    FAIL() << "nothing was told";
  } catch (const std::invalid_argument& error) {
    EXPECT_EQ(
        std::string(error.what()),
        "clip 'B': position would be 0.001 in the file, expected 0; if it is shared by an alias, give it a "
        "value of its own");
  }
}

TEST(SceneWriter, ASectionThatNoGeometryHasBecomesAStiffness) {
  const std::string text = readSceneFile(pathOf("hose"));
  const std::string varied =
      with(text, "measures:", "  - {name: EI, cable: hose, property: EI, tolerance: 10 %}\nmeasures:");
  Design design = designOf(varied);
  setNominal(design, "EI", 1.1 * design.scene.design_variables.back().nominal);
  EXPECT_EQ(saved(varied, design).harness.cables[0].sections[0].section.young_modulus, 0.0);
}

TEST(SceneWriter, AComponentThatIsPlacedTakesAlongWhatRidesOnIt) {
  Design design = designOf(kScene);
  setNominal(design, "b_x", 0.003);
  const Pose there{{0.05, 0.01, 0.02}, Eigen::Quaterniond(Eigen::AngleAxisd(0.3, Eigen::Vector3d::UnitY()))};
  placeComponent(design, "a", there, {});
  placeClip(design, "B", there, {});
  ComponentPoses places = placesOf(design, {});
  const ComponentPoses poses = componentPosesAt(design.scene, design.shifted, places);
  EXPECT_LT((poses.at("a").position - there.position).norm(), 1e-12);
  EXPECT_LT((poses.at("b").position - there.position).norm(), 1e-12);
  EXPECT_LT((harnessAt(design, {}, places).clips[1].pose.position - there.position).norm(), 1e-12);
  // where tf has it, the shift comes on top, and what rides on it comes along
  places = placesOf(design, {{"a", {{1.0, 0.0, 0.0}, Eigen::Quaterniond::Identity()}}});
  EXPECT_LT((places.at("b").position - Eigen::Vector3d(1.04, 0.01, 0.02)).norm(), 1e-12);
  // once more: from where it is
  placeComponent(design, "b", Pose(), {});
  EXPECT_LT(placesOf(design, {}).at("b").position.norm(), 1e-12);
  saved(kScene, design);
}

}  // namespace
}  // namespace cable_variation
