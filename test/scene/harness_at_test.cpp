#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include <cable_variation/scene/scene.h>
#include <cable_variation/scene_file/scene_reader.h>

#include "test_packages.h"

namespace cable_variation {
namespace {

using Eigen::AngleAxisd;
using Eigen::Quaterniond;
using Eigen::Vector3d;

const Scene& everything() {
  static const Scene scene =
      readScene(findTestPackage("test_data") + "/scenes/everything.yaml", findTestPackage);
  return scene;
}

const Clip& clip(const Harness& harness, const std::string& name) {
  for (const Clip& candidate : harness.clips) {
    if (candidate.name == name) return candidate;
  }
  throw std::out_of_range(name);
}

const Cable& cable(const Harness& harness, const std::string& name) {
  for (const Cable& candidate : harness.cables) {
    if (candidate.name == name) return candidate;
  }
  throw std::out_of_range(name);
}

void expectNear(const Pose& a, const Pose& b, double tolerance = 1e-12) {
  EXPECT_NEAR((a.position - b.position).norm(), 0.0, tolerance);
  EXPECT_NEAR(a.orientation.angularDistance(b.orientation), 0.0, 1e-7);
}

std::string refusal(const DesignValues& values) {
  try {
    harnessAt(everything(), values);
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "";
}

TEST(HarnessAt, nothingChangedIsTheSceneItself) {
  const Harness harness = harnessAt(everything(), {});
  for (std::size_t i = 0; i < harness.clips.size(); ++i) {
    expectNear(harness.clips[i].pose, everything().harness.clips[i].pose);
  }
}

TEST(HarnessAt, nominalValuesChangeNothing) {
  DesignValues values;
  for (const DesignVariable& variable : everything().design_variables)
    values[variable.name] = variable.nominal;
  const Harness harness = harnessAt(everything(), values);
  for (std::size_t i = 0; i < harness.clips.size(); ++i) {
    expectNear(harness.clips[i].pose, everything().harness.clips[i].pose);
    EXPECT_DOUBLE_EQ(harness.clips[i].arc_length, everything().harness.clips[i].arc_length);
  }
  for (std::size_t i = 0; i < harness.cables.size(); ++i) {
    const Section& now = harness.cables[i].sections.front().section;
    const Section& then = everything().harness.cables[i].sections.front().section;
    EXPECT_DOUBLE_EQ(now.EI_y, then.EI_y);
    EXPECT_DOUBLE_EQ(now.mass_per_length, then.mass_per_length);
  }
}

// p = p0 + R0 t, R = R0 exp(θ)
TEST(HarnessAt, aClipMovesInItsOwnFrame) {
  const Pose nominal = clip(everything().harness, "fixed").pose;
  const Pose pose = clip(harnessAt(everything(), {{"clip_shift", 0.002}, {"clip_turn", 0.1}}), "fixed").pose;
  EXPECT_NEAR((pose.position - (nominal.position + nominal.orientation * Vector3d(0.002, 0.0, 0.0))).norm(),
              0.0, 1e-12);
  const Quaterniond turned = nominal.orientation * Quaterniond(AngleAxisd(0.1, Vector3d::UnitY()));
  EXPECT_NEAR(pose.orientation.angularDistance(turned), 0.0, 1e-7);
}

TEST(HarnessAt, aComponentTakesItsClipsAlong) {
  const Pose part = componentPose(everything(), "bracket");
  const Pose nominal = clip(everything().harness, "fixed").pose;
  const Harness harness = harnessAt(everything(), {{"bracket_shift", 0.003}, {"bracket_turn", 0.05}});
  const Pose deviation{{0.0, 0.0, 0.003}, Quaterniond(AngleAxisd(0.05, Vector3d::UnitX()))};
  expectNear(clip(harness, "fixed").pose, part * deviation * part.inverse() * nominal);
  expectNear(clip(harness, "rolling").pose,
             clip(everything().harness, "rolling").pose);  // rides on the world
}

TEST(HarnessAt, aLocatorMovesThePartByTheExactRigidMotion) {
  const double deviation = 0.5e-3;
  const ComponentPoses poses = componentPosesAt(everything(), {{"bracket_A1", deviation}});
  const Pose motion = componentPose(everything(), "bracket").inverse() * poses.at("bracket");
  const auto& locators = everything().components[1].locators;
  for (std::size_t i = 0; i < 6; ++i) {
    const auto& [point, direction] = locators[i];
    EXPECT_NEAR(direction.dot(motion * point - point), i == 0 ? deviation : 0.0, 1e-12) << i;
  }
  expectNear(clip(harnessAt(everything(), {{"bracket_A1", deviation}}), "fixed").pose,
             poses.at("bracket") * everything().clip_mounts[0].pose);
}

TEST(HarnessAt, movedComponentsCarryWhatRidesOnThem) {
  const Pose engine{{5.0, 6.0, 7.0}, Quaterniond(AngleAxisd(1.0, Vector3d(0.6, 0.0, 0.8)))};
  const Harness harness = harnessAt(everything(), {}, {{"engine", engine}});
  const Pose bracket = engine * everything().components[1].pose;
  expectNear(clip(harness, "fixed").pose, bracket * everything().clip_mounts[0].pose);
}

// A pose from tf tells where a part would be as designed; its own deviation and its parent's come on top.
TEST(HarnessAt, deviationsAddToMovedPoses) {
  Scene scene = everything();
  DesignVariable engine_turn;
  engine_turn.name = "engine_turn";
  engine_turn.target = ComponentRotation{2, Axis::z};
  scene.design_variables.push_back(engine_turn);
  const Pose engine{{5.0, 0.0, 0.0}, Quaterniond(AngleAxisd(0.7, Vector3d::UnitX()))};
  const Pose bracket{{5.0, 2.0, 0.0}, Quaterniond::Identity()};
  const ComponentPoses moved{{"engine", engine}, {"bracket", bracket}};
  const DesignValues values{{"engine_turn", 0.2}, {"bracket_shift", 0.01}};
  const ComponentPoses poses = componentPosesAt(scene, values, moved);
  const Pose turn{Vector3d::Zero(), Quaterniond(AngleAxisd(0.2, Vector3d::UnitZ()))};
  const Pose shift{{0.0, 0.0, 0.01}, Quaterniond::Identity()};
  expectNear(poses.at("engine"), engine * turn);
  expectNear(poses.at("bracket"), engine * turn * engine.inverse() * bracket * shift);
}

TEST(HarnessAt, lengthKeepsClipsWhereTheyAreAndTheEndAtTheEnd) {
  const Harness harness = harnessAt(everything(), {{"main_length", 0.320}});
  EXPECT_DOUBLE_EQ(cable(harness, "main").length, 0.320);
  EXPECT_DOUBLE_EQ(clip(harness, "sliding_rolling").arc_length, 0.140);
  EXPECT_DOUBLE_EQ(clip(harness, "free").arc_length, 0.320);
  EXPECT_DOUBLE_EQ(harness.loads[0].arc_length, 0.320);  // the free end's
  EXPECT_DOUBLE_EQ(harness.joints[0].parent_arc_length, 0.258);
}

TEST(HarnessAt, lengthScalesClipsAndRestShapeWhereAskedTo) {
  const double factor = 0.9;
  const Harness harness = harnessAt(everything(), {{"hose_length", 0.33 * factor}});
  EXPECT_DOUBLE_EQ(clip(harness, "sliding").arc_length, 0.1 * factor);
  EXPECT_DOUBLE_EQ(harness.joints[1].parent_arc_length, 0.33 * factor);
  const auto& curvature = cable(harness, "hose").rest_curvature;
  EXPECT_DOUBLE_EQ(curvature[1].arc_length, 0.33 * factor);
  EXPECT_DOUBLE_EQ(curvature[1].curvature.z(), 4.0 / factor);  // the same total angle
}

TEST(HarnessAt, aShortenedCableIsCutAtItsEnd) {
  Scene scene = everything();
  scene.design_variables.push_back({});
  scene.design_variables.back().name = "cut";
  scene.design_variables.back().target = CableProperty{2, CableProperty::Property::length};
  const Harness harness = harnessAt(scene, {{"cut", 0.31}});
  const auto& curvature = cable(harness, "hose").rest_curvature;
  ASSERT_EQ(curvature.size(), 2U);
  EXPECT_DOUBLE_EQ(curvature[1].arc_length, 0.31);
  EXPECT_NEAR(curvature[1].curvature.z(), 2.0 + 2.0 * 0.31 / 0.33, 1e-12);
}

TEST(HarnessAt, stiffnessScalesAllAlong) {
  const Harness harness = harnessAt(
      everything(), {{"bending", 0.134}, {"torsion", 0.023}, {"stretch", 2400.0}, {"weight", 0.48}});
  const Section& section = cable(harness, "hose").sections[0].section;
  EXPECT_NEAR(section.EI_y, 0.134, 1e-15);
  EXPECT_NEAR(section.EI_z, 0.12, 1e-15);
  EXPECT_NEAR(section.GJ, 0.023, 1e-15);
  EXPECT_NEAR(section.EA, 2400.0, 1e-9);
  EXPECT_NEAR(section.GA_y, 410.0, 1e-12);
  EXPECT_NEAR(section.mass_per_length, 0.48, 1e-15);
  const Harness bent = harnessAt(everything(), {{"shape", 1.1}});
  EXPECT_NEAR(cable(bent, "hose").rest_curvature[0].curvature.z(), 2.2, 1e-12);
}

TEST(HarnessAt, aGeometricSectionGetsStifferWithItsRadius) {
  const Material bundle{1e8, 0.25, 2000.0};
  const Section expected = solidSection(0.0044, bundle);
  const Section grown = cable(harnessAt(everything(), {{"radius", 0.0044}}), "main").sections[0].section;
  EXPECT_NEAR(grown.radius, expected.radius, 1e-15);
  EXPECT_NEAR(grown.EA / expected.EA, 1.0, 1e-12);
  EXPECT_NEAR(grown.GA_y / expected.GA_y, 1.0, 1e-12);
  EXPECT_NEAR(grown.EI_z / expected.EI_z, 1.0, 1e-12);
  EXPECT_NEAR(grown.GJ / expected.GJ, 1.0, 1e-12);
  EXPECT_NEAR(grown.mass_per_length / expected.mass_per_length, 1.0, 1e-12);
}

TEST(HarnessAt, aMeasuredStiffnessStaysWhenTheRadiusChanges) {
  const Section section =
      cable(harnessAt(everything(), {{"hose_radius", 0.013}}), "hose").sections[0].section;
  EXPECT_DOUBLE_EQ(section.radius, 0.013);
  EXPECT_DOUBLE_EQ(section.EI_y, 0.067);
}

TEST(HarnessAt, arcLengths) {
  const Harness harness = harnessAt(everything(), {{"clip_place", 0.06}, {"breakout_place", 0.25}});
  EXPECT_DOUBLE_EQ(clip(harness, "hinge").arc_length, 0.06);
  EXPECT_DOUBLE_EQ(harness.joints[0].parent_arc_length, 0.25);
}

TEST(HarnessAt, refusesWhatIsNotThereOrNotPhysical) {
  EXPECT_EQ(refusal({{"nothing", 0.0}}), "there is no design variable 'nothing'");
  EXPECT_EQ(refusal({{"clip_turn", std::numeric_limits<double>::quiet_NaN()}}),
            "design variable 'clip_turn': value nan; expected a finite number");
  EXPECT_EQ(refusal({{"main_length", -0.1}}),
            "design variable 'main_length': cable 'main': length -0.1; expected more than 0");
  EXPECT_EQ(refusal({{"bending", 0.0}}),
            "design variable 'bending': cable 'hose': EI 0; expected more than 0");
  EXPECT_EQ(refusal({{"breakout_place", 0.4}}),
            "design variable 'breakout_place': arc length 0.4 m; expected between 0 and 0.312 m");
  EXPECT_NE(refusal({{"main_length", 0.13}}), "");  // shorter than the place of a clip
  EXPECT_NE(refusal({{"bracket_A1", 1.0}}), "");    // further than the part can turn
}

}  // namespace
}  // namespace cable_variation
