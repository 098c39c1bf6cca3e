// A design as text: read back it is the same, to the last bit, in the shape that it had; what is no such text
// is refused.
#include <cable_variation/tracking/saved_design.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <stdexcept>
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

Scene sceneFrom(const std::string& package, const std::string& file) {
  return readScene(findTestPackage(package) + file, findTestPackage);
}

/// Every variable anywhere in its tolerance, and edits of each kind.
Design editedDesign(const Scene& loaded, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<> share(-1.0, 1.0);
  Design design{loaded, {}, {}};
  for (const DesignVariable& variable : loaded.design_variables) {
    const double deviation = std::uniform_real_distribution<>(variable.lower, variable.upper)(random);
    setNominal(design, variable.name, variable.nominal + deviation);
  }
  const Harness& harness = design.scene.harness;
  setCableLength(design, harness.cables[0].name, harness.cables[0].length * (1.0 + 1e-4 * share(random)));
  for (const Component& component : loaded.components) {
    Pose pose = component.pose;
    pose.position += 1e-4 * Eigen::Vector3d(share(random), share(random), share(random));
    setComponentPose(design, component.name, pose);
  }
  const std::string clip = harness.clips[0].name;
  moveClip(design, clip, 1e-4 * Eigen::Vector3d(share(random), share(random), share(random)),
           Eigen::Vector3d(1e-3 * share(random), 0.0, 0.0));
  Clip added;
  added.name = "a clip, 100 % new";
  added.type = "eyelet";
  added.arc_length = 0.513 * harness.cables[0].length;
  added.attached = false;
  addClip(design, added, {loaded.components.empty() ? "world" : loaded.components.back().name, Pose()});
  return design;
}

void expectSame(const Harness& a, const Harness& b) {
  ASSERT_EQ(a.clips.size(), b.clips.size());
  for (std::size_t i = 0; i < a.clips.size(); ++i) {
    EXPECT_EQ(a.clips[i].name, b.clips[i].name);
    EXPECT_EQ(a.clips[i].type, b.clips[i].type);
    EXPECT_EQ(a.clips[i].attached, b.clips[i].attached);
    EXPECT_EQ(a.clips[i].arc_length, b.clips[i].arc_length);
    EXPECT_EQ(a.clips[i].constraint.slides, b.clips[i].constraint.slides);
    EXPECT_EQ(a.clips[i].pose.position, b.clips[i].pose.position) << a.clips[i].name;
    EXPECT_EQ(a.clips[i].pose.orientation.coeffs(), b.clips[i].pose.orientation.coeffs());
  }
  for (std::size_t c = 0; c < a.cables.size(); ++c) {
    EXPECT_EQ(a.cables[c].length, b.cables[c].length);
    ASSERT_EQ(a.cables[c].sections.size(), b.cables[c].sections.size());
    for (std::size_t i = 0; i < a.cables[c].sections.size(); ++i) {
      const Section &x = a.cables[c].sections[i].section, &y = b.cables[c].sections[i].section;
      EXPECT_EQ(a.cables[c].sections[i].arc_length, b.cables[c].sections[i].arc_length);
      EXPECT_EQ(x.EA, y.EA);
      EXPECT_EQ(x.GA_y, y.GA_y);
      EXPECT_EQ(x.GA_z, y.GA_z);
      EXPECT_EQ(x.GJ, y.GJ);
      EXPECT_EQ(x.EI_y, y.EI_y);
      EXPECT_EQ(x.EI_z, y.EI_z);
      EXPECT_EQ(x.mass_per_length, y.mass_per_length);
      EXPECT_EQ(x.radius, y.radius);
      EXPECT_EQ(x.young_modulus, y.young_modulus);
      EXPECT_EQ(x.shear_modulus, y.shear_modulus);
      EXPECT_EQ(x.width, y.width);
      EXPECT_EQ(x.height, y.height);
    }
    ASSERT_EQ(a.cables[c].rest_curvature.size(), b.cables[c].rest_curvature.size());
    for (std::size_t i = 0; i < a.cables[c].rest_curvature.size(); ++i) {
      EXPECT_EQ(a.cables[c].rest_curvature[i].arc_length, b.cables[c].rest_curvature[i].arc_length);
      EXPECT_EQ(a.cables[c].rest_curvature[i].curvature, b.cables[c].rest_curvature[i].curvature);
    }
  }
  for (std::size_t i = 0; i < a.joints.size(); ++i) {
    EXPECT_EQ(a.joints[i].parent_arc_length, b.joints[i].parent_arc_length);
    EXPECT_EQ(a.joints[i].child_arc_length, b.joints[i].child_arc_length);
  }
  for (std::size_t i = 0; i < a.loads.size(); ++i) EXPECT_EQ(a.loads[i].arc_length, b.loads[i].arc_length);
}

TEST(SavedDesign, IsReadBackToTheLastBit) {
  for (const auto& [package, file] : {std::pair("test_data", "/scenes/everything.yaml"),
                                      std::pair("cable_variation", "/config/harness_clipped.yaml"),
                                      std::pair("cable_variation", "/config/hose.yaml")}) {
    const Scene loaded = sceneFrom(package, file);
    for (unsigned seed = 0; seed < 5; ++seed) {
      SCOPED_TRACE(std::string(file) + " " + std::to_string(seed));
      const Design design = editedDesign(loaded, seed);
      const std::string text = savedDesignText(design, loaded, {});
      const SavedDesign saved = readSavedDesign(text, loaded);
      EXPECT_EQ(savedDesignText(saved.design, loaded, {}), text);
      EXPECT_TRUE(saved.shape.shapes.empty());
      EXPECT_EQ(saved.design.shifted, design.shifted);
      for (std::size_t i = 0; i < loaded.design_variables.size(); ++i)
        EXPECT_EQ(saved.design.scene.design_variables[i].nominal, design.scene.design_variables[i].nominal);
      expectSame(saved.design.scene.harness, design.scene.harness);
      expectSame(harnessAt(saved.design, {}, placesOf(saved.design, {})),
                 harnessAt(design, {}, placesOf(design, {})));
    }
  }
}

double largestDistance(const Equilibrium& a, const Equilibrium& b) {
  double largest = 0.0;
  for (std::size_t i = 0; i < a.shapes.size(); ++i) {
    const std::vector<Pose> x = a.shapes[i].sample(101), y = b.shapes[i].sample(101);
    for (std::size_t k = 0; k < x.size(); ++k)
      largest = std::max(largest, (x[k].position - y[k].position).norm());
  }
  return largest;
}

// A strip that flips over when its holder turns by some 25 degrees, and a harness whose clips slide: the
// shape is the one that was followed to, be there another of lower energy or not.
TEST(SavedDesign, HasTheShapeThatItHad) {
  const Scene loaded = sceneFrom("cable_variation", "/test/ros/data/snapping.yaml");
  EquilibriumOptions options;
  options.accuracy = loaded.accuracy;
  int other = 0;
  for (const double degrees : {-20.0, -10.0, 10.0, 20.0}) {
    Design design{loaded, {}, {}};
    EquilibriumSolver followed(options);
    // step by step from the other side, beyond the snap there
    Equilibrium equilibrium;
    const double step = degrees > 0.0 ? 5.0 : -5.0;
    for (double angle = -12.0 * step; std::abs(angle - degrees) > 0.5 * std::abs(step); angle += step) {
      Pose pose = loaded.components[0].pose;
      pose.orientation = Eigen::AngleAxisd((angle + step) * M_PI / 180.0, Eigen::Vector3d::UnitY());
      setComponentPose(design, "holder", pose);
      equilibrium = followed.update(harnessAt(design, {}, placesOf(design, {})));
      ASSERT_TRUE(equilibrium.converged()) << equilibrium.message;
    }
    const SavedDesign saved = readSavedDesign(savedDesignText(design, loaded, equilibrium), loaded);
    const Harness harness = harnessAt(saved.design, {}, placesOf(saved.design, {}));
    EquilibriumSolver solver(options);
    const Equilibrium found = solveSaved(solver, harness, saved.shape);
    ASSERT_TRUE(found.converged()) << found.message;
    EXPECT_LT(largestDistance(found, equilibrium), 0.1 * loaded.accuracy) << degrees;
    EXPECT_TRUE(solver.update(harness).converged());
    if (largestDistance(EquilibriumSolver(options).solve(harness), equilibrium) > 1e-3) ++other;
  }
  EXPECT_GT(other, 0) << "none of these shapes is one that solving from nothing misses";
}

TEST(SavedDesign, WithClipsThatSlideHasTheShapeThatItHad) {
  const Scene loaded = sceneFrom("cable_variation", "/config/harness_clipped.yaml");
  Design design{loaded, {}, {}};
  setCableLength(design, loaded.harness.cables[0].name, loaded.harness.cables[0].length + 0.002);
  EquilibriumOptions options;
  options.accuracy = loaded.accuracy;
  const Equilibrium equilibrium = EquilibriumSolver(options).solve(harnessAt(design, {}));
  ASSERT_TRUE(equilibrium.converged());
  const SavedDesign saved = readSavedDesign(savedDesignText(design, loaded, equilibrium), loaded);
  EXPECT_FALSE(saved.shape.slid.empty());
  EquilibriumSolver solver(options);
  const Equilibrium found = solveSaved(solver, harnessAt(saved.design, {}), saved.shape);
  ASSERT_TRUE(found.converged()) << found.message;
  EXPECT_LT(largestDistance(found, equilibrium), loaded.accuracy);
  for (std::size_t i = 0; i < equilibrium.clip_reactions.size(); ++i)
    EXPECT_NEAR(found.clip_reactions[i].arc_length, equilibrium.clip_reactions[i].arc_length,
                loaded.accuracy);
}

// Shapes from elsewhere lead somewhere: never to an answer that is none.
TEST(SavedDesign, OfPartsAloneHasTheCableThatWasAdded) {
  const Scene loaded = readSceneText("components: [{name: a}]", "parts.yaml", findTestPackage);
  Design design{loaded, {}, {}};
  Pose place;
  place.position.x() = 0.1;
  setComponentPose(design, "a", place);
  SavedDesign again = readSavedDesign(savedDesignText(design, loaded, {}), loaded);
  EXPECT_EQ(again.design.shifts.at("a").position, place.position);
  EXPECT_TRUE(again.design.scene.harness.cables.empty());

  Cable cable;
  cable.name = "a cable, 100 % new";
  cable.length = 0.2;
  cable.sections = {{0.0, solidSection(4e-3, {1e8, 0.25, 2000.0})}};
  addCable(design, cable);
  Clip clip;
  clip.name = "start";
  clip.type = "fixed";
  addClip(design, clip, {"a", Pose()});
  EquilibriumSolver solver;
  const Equilibrium shape = solver.solve(harnessAt(design, {}, placesOf(design, {})));
  ASSERT_TRUE(shape.converged());
  again = readSavedDesign(savedDesignText(design, loaded, shape), loaded);
  expectSame(again.design.scene.harness, design.scene.harness);
  EXPECT_EQ(again.design.scene.harness.cables.front().name, cable.name);
  const Equilibrium found =
      solveSaved(solver, harnessAt(again.design, {}, placesOf(again.design, {})), again.shape);
  ASSERT_TRUE(found.converged());
  EXPECT_LT((found.shapes.front().position(0.2) - shape.shapes.front().position(0.2)).norm(), 1e-6);
}

TEST(SavedDesign, AShapeThatLeadsNowhereIsSolvedFromNothing) {
  const Scene loaded = sceneFrom("cable_variation", "/test/ros/data/snapping.yaml");
  const Design design{loaded, {}, {}};
  const Harness harness = harnessAt(design, {});
  EquilibriumSolver solver;
  const Equilibrium right = solver.solve(harness);
  SavedShape shape{right.shapes, {}};
  for (ShapePoint& point : shape.shapes[0].points) point.pose.position *= 1e9;
  const Equilibrium found = solveSaved(solver, harness, shape);
  ASSERT_TRUE(found.converged()) << found.message;
  shape.shapes.pop_back();
  EXPECT_TRUE(solveSaved(solver, harness, shape).converged());
}

TEST(SavedDesign, TextsThatAreNotWholeAreRefused) {
  const Scene loaded = sceneFrom("cable_variation", "/test/ros/data/snapping.yaml");
  const Equilibrium shape = EquilibriumSolver().solve(loaded.harness);
  const std::string text = savedDesignText({loaded, {}, {}}, loaded, shape);
  EXPECT_NO_THROW(readSavedDesign(text, loaded));
  for (std::size_t size = 0; size + 1 < text.size(); size += 7)
    EXPECT_THROW(readSavedDesign(text.substr(0, size), loaded), std::invalid_argument) << size;
  const auto refusal = [&](const std::string& before, const std::string& after) {
    std::string changed = text;
    const std::size_t at = changed.find(before);
    EXPECT_NE(at, std::string::npos) << before;
    changed.replace(at, before.size(), after);
    try {
      readSavedDesign(changed, loaded);
    } catch (const std::invalid_argument& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  EXPECT_EQ(refusal("cable 0", "cable 1"), "line 1: 1; expected one of 1");
  EXPECT_EQ(refusal("cable 0", "cable 0.5"), "line 1: 0.5; expected one of 1");
  EXPECT_EQ(refusal("cable 0", "cables 0"), "line 1: 'cables' is nothing that a design has");
  EXPECT_EQ(refusal("cable 0", "cable 0 x"), "line 1: 'x'; expected a number");
  EXPECT_NE(refusal("cable 0", "cable 0 1").find("is one too many"), std::string::npos);
  EXPECT_NE(refusal("section", "cable 0 -1\nsection").find("length"), std::string::npos);
  EXPECT_NE(
      refusal("end\n", "added x pear world 0 1 0.1 0 0 0 0 0 0 1\nend\n").find("no clip of type 'pear'"),
      std::string::npos);
  EXPECT_NE(refusal("end\n", "added x eyelet car 0 1 0.1 0 0 0 0 0 0 1\nend\n").find("car"),
            std::string::npos);
  EXPECT_NE(refusal("end\n", "shift 0 0 0 0 0 0 0 2\nend\n").find("quaternion"), std::string::npos);
  // a design of another scene
  const Scene other = sceneFrom("cable_variation", "/config/harness.yaml");
  EXPECT_THROW(readSavedDesign(text, other), std::invalid_argument);
  EXPECT_THROW(readSavedDesign(savedDesignText({other, {}, {}}, other, {}), loaded), std::invalid_argument);
}

}  // namespace
}  // namespace cable_variation
