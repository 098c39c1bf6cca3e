#include <cable_variation/scene_file/scene_reader.h>

#include <cmath>
#include <filesystem>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "test_packages.h"

namespace cable_variation {
namespace {

using Eigen::Quaterniond;
using Eigen::Vector3d;

const Scene& everything() {
  static const Scene scene =
      readScene(findTestPackage("test_data") + "/scenes/everything.yaml", findTestPackage);
  return scene;
}

template <typename Named>
const Named& named(const std::vector<Named>& things, const std::string& name) {
  for (const Named& thing : things) {
    if (thing.name == name) return thing;
  }
  throw std::out_of_range(name);
}

void expectNear(const Vector3d& a, const Vector3d& b, double tolerance = 1e-9) {
  EXPECT_NEAR((a - b).norm(), 0.0, tolerance) << a.transpose() << " and " << b.transpose();
}

TEST(SceneReader, worldAndAccuracy) {
  expectNear(everything().harness.gravity, {0.0, 0.0, -9.81});
  EXPECT_DOUBLE_EQ(everything().accuracy, 5e-5);
}

TEST(SceneReader, components) {
  const Component& bay = named(everything().components, "bay");
  EXPECT_EQ(bay.visuals.size(), 5U);
  expectNear(named(bay.visuals, "finger").pose.position, {0.02, 0.0, 0.7});  // joints at 90 deg and 20 mm

  const Component& bracket = named(everything().components, "bracket");
  ASSERT_EQ(bracket.visuals.size(), 1U);
  EXPECT_EQ(bracket.visuals[0].mesh_resource, "package://test_data/meshes/tetrahedron.stl");
  EXPECT_EQ(bracket.visuals[0].color, Eigen::Vector4d(0.2, 0.4, 0.6, 1.0));
  expectNear(bracket.visuals[0].mesh_scale, {0.001, 0.001, 0.001});
  EXPECT_EQ(bracket.parent, "engine");
  ASSERT_EQ(bracket.locators.size(), 6U);
  expectNear(bracket.locators[0].second, {0.0, 0.0, 1.0});
  EXPECT_TRUE(named(everything().components, "engine").visuals.empty());
  EXPECT_EQ(named(everything().components, "engine").driven_by, ComponentDriver::tf);
  EXPECT_EQ(bracket.driven_by, ComponentDriver::scene);
}

TEST(SceneReader, theLinksOfARobotThatJointStatesDriveAreComponents) {
  const Component& root = named(everything().components, "robot");
  EXPECT_EQ(root.visuals.size(), 2U);
  EXPECT_EQ(root.robot, "robot");
  EXPECT_FALSE(root.joint);
  const Component& finger = named(everything().components, "robot/finger");
  EXPECT_EQ(finger.parent, "robot/upper");
  EXPECT_EQ(finger.robot, "robot");
  EXPECT_EQ(finger.driven_by, ComponentDriver::joint_states);
  ASSERT_TRUE(finger.joint);
  EXPECT_EQ(finger.joint->driver, "grip");
  ASSERT_EQ(finger.visuals.size(), 1U);
  expectNear(finger.visuals[0].pose.position, {0.0, 0.0, 0.0});
  expectNear(componentPose(everything(), "tool").position, {0.0, 0.0, 0.7});  // the shoulder turned by 90 deg
}

TEST(SceneReader, aPoseIsInItsParent) {
  // the engine is at (1, 0, 0), a quarter turn about z; the bracket in it at (0.1, 0, 0.02), another quarter
  const Pose pose = componentPose(everything(), "bracket");
  expectNear(pose.position, {1.0, 0.1, 0.02}, 1e-7);
  expectNear(pose.orientation * Vector3d::UnitX(), {-1.0, 0.0, 0.0}, 1e-7);
  EXPECT_EQ(componentPose(everything(), "world").position.norm(), 0.0);
  EXPECT_THROW(componentPose(everything(), "nothing"), std::invalid_argument);
}

TEST(SceneReader, cables) {
  const Cable& main = named(everything().harness.cables, "main");
  EXPECT_DOUBLE_EQ(main.length, 0.312);
  ASSERT_EQ(main.sections.size(), 1U);
  EXPECT_NEAR(main.sections[0].section.EA, 1e8 * M_PI * 16e-6, 1e-6);
  EXPECT_NEAR(main.sections[0].section.mass_per_length, 2000.0 * M_PI * 16e-6, 1e-12);
  ASSERT_EQ(main.via.size(), 2U);
  expectNear(main.via[1], {0.2, 0.0, 0.05});
  EXPECT_NEAR(*main.twist, -3.0 * M_PI, 1e-12);

  const Section& hose = named(everything().harness.cables, "hose").sections[0].section;
  EXPECT_DOUBLE_EQ(hose.GA_y, 410.0);
  EXPECT_DOUBLE_EQ(hose.GA_z, 410.0);
  EXPECT_DOUBLE_EQ(hose.EI_y, 0.067);
  EXPECT_NEAR(hose.EI_z, 0.06, 1e-15);
  EXPECT_DOUBLE_EQ(hose.mass_per_length, 0.24);
  EXPECT_DOUBLE_EQ(hose.radius, 0.012);
  const auto& curvature = named(everything().harness.cables, "hose").rest_curvature;
  ASSERT_EQ(curvature.size(), 2U);
  EXPECT_DOUBLE_EQ(curvature[1].arc_length, 0.33);
  expectNear(curvature[1].curvature, {0.0, 0.0, 4.0});

  const Cable& stepped = named(everything().harness.cables, "stepped");
  ASSERT_EQ(stepped.sections.size(), 3U);
  EXPECT_NEAR(stepped.sections[0].section.EA, stepped.sections[1].section.EA, 1e-9);  // wall 3 mm: inner 9 mm
  EXPECT_GT(stepped.sections[2].section.EA, stepped.sections[1].section.EA);
  for (const RestCurvatureAt& knot : stepped.rest_curvature)
    expectNear(knot.curvature, Vector3d::Zero(), 1e-6);

  const Section& branch = named(everything().harness.cables, "branch").sections[0].section;
  EXPECT_NEAR(branch.EI_y, 0.2e9 * 6e-3 * std::pow(2e-3, 3) / 12.0, 1e-12);
}

TEST(SceneReader, clipPresets) {
  using Kind = ClipFreedom::Kind;
  const auto& clips = everything().harness.clips;
  const auto kinds = [&](const std::string& name) {
    const ClipConstraint& c = named(clips, name).constraint;
    std::string text;
    for (const auto* freedoms : {&c.translation, &c.rotation}) {
      for (const ClipFreedom& f : *freedoms)
        text += f.kind == Kind::locked ? 'L' : f.kind == Kind::free ? 'f' : 's';
    }
    return text + (c.slides ? " slides" : "");
  };
  EXPECT_EQ(kinds("fixed"), "LLLLLL");
  EXPECT_EQ(kinds("rolling"), "LLLfLL");
  EXPECT_EQ(kinds("pivot"), "LLLfff");
  EXPECT_EQ(kinds("hinge"), "LLLLLf");
  EXPECT_EQ(kinds("sliding"), "LLLLLL slides");
  EXPECT_EQ(kinds("sliding_rolling"), "LLLfLL slides");
  EXPECT_EQ(kinds("eyelet"), "LLLfff slides");
  EXPECT_EQ(kinds("guide"), "fLLfLL");
  EXPECT_EQ(kinds("plane"), "ffLfff");
  EXPECT_EQ(kinds("grommet"), "ssssss slides");
  EXPECT_EQ(kinds("free"), "ffffff");
  EXPECT_EQ(kinds("general"),
            "Lfsfs"
            "L");
  EXPECT_EQ(named(clips, "sliding").type, "sliding");

  const ClipConstraint& grommet = named(clips, "grommet").constraint;
  EXPECT_DOUBLE_EQ(grommet.translation[0].stiffness, 1000.0);
  EXPECT_DOUBLE_EQ(grommet.translation[2].stiffness, 2000.0);
  EXPECT_DOUBLE_EQ(grommet.rotation[0].stiffness, 0.1);
  EXPECT_DOUBLE_EQ(grommet.rotation[1].stiffness, 0.2);
  const ClipConstraint& general = named(clips, "general").constraint;
  EXPECT_DOUBLE_EQ(general.translation[2].stiffness, 3000.0);
  EXPECT_NEAR(general.rotation[1].stiffness, 0.5e-3 * 180.0 / M_PI, 1e-12);
}

TEST(SceneReader, clipPosesAreResolvedToTheWorld) {
  const auto& clips = everything().harness.clips;
  const Clip& fixed = named(clips, "fixed");
  expectNear(fixed.pose.position, {1.0, 0.1, 0.021}, 1e-7);
  expectNear(fixed.pose.orientation * Vector3d::UnitX(), {0.0, 0.0, 1.0}, 1e-7);

  // x_axis y, y_axis towards -x, then a quarter turn about x: y becomes z
  const Quaterniond q = named(clips, "sliding_rolling").pose.orientation;
  expectNear(q * Vector3d::UnitX(), {0.0, 1.0, 0.0});
  expectNear(q * Vector3d::UnitY(), {0.0, 0.0, 1.0});
  EXPECT_DOUBLE_EQ(named(clips, "free").arc_length, 0.312);
}

TEST(SceneReader, jointsAndLoads) {
  const Harness& harness = everything().harness;
  const Joint& breakout = named(harness.joints, "breakout");
  EXPECT_EQ(breakout.type, Joint::Type::fixed);
  EXPECT_EQ(harness.cables[breakout.parent].name, "main");
  EXPECT_EQ(harness.cables[breakout.child].name, "branch");
  EXPECT_DOUBLE_EQ(breakout.parent_arc_length, 0.258);
  EXPECT_DOUBLE_EQ(breakout.child_arc_length, 0.0);
  const double turn = 35.0 * M_PI / 180.0;
  expectNear(breakout.rotation * Vector3d::UnitX(), {std::cos(turn), std::sin(turn), 0.0});
  const Joint& hinged = named(harness.joints, "hinged");
  EXPECT_EQ(hinged.type, Joint::Type::hinge);
  EXPECT_DOUBLE_EQ(hinged.parent_arc_length, 0.33);
  EXPECT_DOUBLE_EQ(hinged.child_arc_length, 0.4);
  expectNear(hinged.axis, Vector3d::UnitY());

  const PointLoad& free_end = named(harness.loads, "free");
  expectNear(free_end.force, {0.0, 0.0, -1.0});
  expectNear(free_end.moment, {0.0, 0.01, 0.0});
  EXPECT_DOUBLE_EQ(free_end.arc_length, 0.312);
  expectNear(named(harness.loads, "tool").force, {0.0, 2.0, 0.0});
}

TEST(SceneReader, designVariables) {
  const auto& variables = everything().design_variables;
  const DesignVariable& turn = named(variables, "clip_turn");
  EXPECT_EQ(turn.unit, "rad");
  EXPECT_EQ(turn.nominal, 0.0);
  EXPECT_NEAR(turn.upper, 5.0 * M_PI / 180.0, 1e-15);
  EXPECT_EQ(turn.lower, -turn.upper);
  EXPECT_EQ(turn.distribution_parameters.at("sigma"), 3.0);

  const DesignVariable& length = named(variables, "main_length");
  EXPECT_DOUBLE_EQ(length.nominal, 0.312);
  EXPECT_DOUBLE_EQ(length.lower, -0.003);
  EXPECT_DOUBLE_EQ(length.upper, 0.005);
  EXPECT_DOUBLE_EQ(length.distribution_parameters.at("mode"), 0.001);
  EXPECT_FALSE(std::get<CableProperty>(length.target).clips_scale);
  EXPECT_TRUE(std::get<CableProperty>(named(variables, "hose_length").target).clips_scale);
  EXPECT_TRUE(std::get<CableProperty>(named(variables, "radius").target).similar);
  EXPECT_FALSE(std::get<CableProperty>(named(variables, "hose_radius").target).similar);

  const DesignVariable& bending = named(variables, "bending");
  EXPECT_EQ(bending.unit, "N m^2");
  EXPECT_NEAR(bending.upper, 0.2 * 0.067, 1e-15);
  EXPECT_NEAR(named(variables, "torsion").lower, -0.1 * 4.6e-2, 1e-15);
  EXPECT_EQ(named(variables, "torsion").distribution, "normal");
  EXPECT_EQ(named(variables, "weight").unit, "kg/m");
  EXPECT_EQ(named(variables, "shape").unit, "1");

  const DesignVariable& place = named(variables, "breakout_place");
  EXPECT_EQ(place.distribution_values, (std::vector<double>{-0.004, 0.0, 0.004}));
  EXPECT_EQ(place.distribution_weights, (std::vector<double>{0.25, 0.5, 0.25}));
  const DesignVariable& sampled = named(variables, "bracket_shift");
  ASSERT_EQ(sampled.distribution_values.size(), 3U);
  EXPECT_NEAR(sampled.distribution_values[0], -0.0004, 1e-15);
}

TEST(SceneReader, regionsAreVariablesThatBelongTogether) {
  const Scene& scene = everything();
  const auto& variables = scene.design_variables;
  ASSERT_EQ(scene.tolerance_regions.size(), 3U);

  const ToleranceRegion& tip = named(scene.tolerance_regions, "tip");
  EXPECT_EQ(tip.shape, ToleranceRegion::Shape::ball);
  EXPECT_DOUBLE_EQ(tip.radius, 0.0005);
  EXPECT_TRUE(tip.uniform);
  ASSERT_EQ(tip.variables.size(), 3U);
  EXPECT_EQ(variables[tip.variables[0]].name, "tip_x");
  EXPECT_EQ(variables[tip.variables[2]].name, "tip_z");
  const DesignVariable& tip_y = variables[tip.variables[1]];
  EXPECT_EQ(std::get<ClipTranslation>(tip_y.target).axis, Axis::y);
  EXPECT_EQ(std::get<ClipTranslation>(tip_y.target).clip, 4U);
  EXPECT_DOUBLE_EQ(tip_y.lower, -0.0005);
  EXPECT_EQ(tip_y.unit, "m");
  EXPECT_EQ(tip_y.distribution, "ball");

  const ToleranceRegion& face = named(scene.tolerance_regions, "face");
  EXPECT_FALSE(face.uniform);
  EXPECT_DOUBLE_EQ(face.sigma, 3.0);
  ASSERT_EQ(face.variables.size(), 2U);
  EXPECT_EQ(variables[face.variables[1]].name, "face_y");
  EXPECT_EQ(std::get<ComponentTranslation>(variables[face.variables[1]].target).component, 1U);

  const ToleranceRegion& aim = named(scene.tolerance_regions, "aim");
  EXPECT_DOUBLE_EQ(aim.sigma, 2.0);
  ASSERT_EQ(aim.variables.size(), 2U);
  const DesignVariable& aim_ry = variables[aim.variables[0]];
  EXPECT_EQ(aim_ry.name, "aim_ry");
  EXPECT_EQ(std::get<ClipRotation>(aim_ry.target).axis, Axis::y);
  EXPECT_NEAR(aim_ry.upper, 2.0 * M_PI / 180.0, 1e-15);
  EXPECT_EQ(aim_ry.distribution_parameters.at("sigma"), 2.0);
}

TEST(SceneReader, correlations) {
  const Scene& scene = everything();
  ASSERT_EQ(scene.correlations.size(), 2U);
  EXPECT_EQ(scene.design_variables[scene.correlations[0].first].name, "bending");
  EXPECT_EQ(scene.design_variables[scene.correlations[0].second].name, "torsion");
  EXPECT_DOUBLE_EQ(scene.correlations[0].coefficient, 0.8);
}

using Indices = std::vector<std::size_t>;  // everything.yaml: main 0, branch 1, hose 2, stepped 3

TEST(SceneReader, measuresOfDistance) {
  const auto& measures = everything().measures;
  const Measure& to_bracket = named(measures, "to_bracket");
  EXPECT_EQ(to_bracket.type, Measure::Type::distance);
  EXPECT_EQ(to_bracket.unit, "m");
  EXPECT_EQ(to_bracket.cables, (Indices{0, 1}));
  EXPECT_EQ(to_bracket.component, std::size_t{1});
  EXPECT_DOUBLE_EQ(to_bracket.skip_near_clips, 0.03);
  EXPECT_DOUBLE_EQ(*to_bracket.lower, 0.005);
  EXPECT_FALSE(to_bracket.upper);

  const Measure& to_branch = named(measures, "to_branch");
  EXPECT_EQ(to_branch.cables, (Indices{0, 2, 3})) << "all others";
  EXPECT_EQ(to_branch.other_cables, (Indices{1}));
  EXPECT_FALSE(to_branch.component);
  // main of radius 4 mm and branch of 6 x 2 mm are joined
  EXPECT_DOUBLE_EQ(to_branch.skip_near_joints, 4.0 * (0.004 + std::hypot(0.003, 0.001)));
  EXPECT_DOUBLE_EQ(named(measures, "apart").skip_near_joints, 0.025);
  EXPECT_DOUBLE_EQ(named(measures, "apart").skip_near_clips, 0.0);
}

TEST(SceneReader, measuresOfShape) {
  const auto& measures = everything().measures;
  const Measure& same = named(measures, "same");
  EXPECT_EQ(same.type, Measure::Type::similarity);
  EXPECT_EQ(same.cables, (Indices{0, 1, 2, 3}));
  EXPECT_FALSE(same.surface);
  EXPECT_TRUE(named(measures, "same_surface").surface);
  EXPECT_EQ(named(measures, "same_surface").cables, (Indices{0}));

  const Measure& height = named(measures, "height");
  EXPECT_EQ(height.cables, (Indices{0}));
  EXPECT_DOUBLE_EQ(*height.arc_length, 0.1);
  expectNear(height.direction, Vector3d::UnitZ());
  EXPECT_DOUBLE_EQ(*height.upper, 1.0);
  EXPECT_EQ(named(measures, "bend").type, Measure::Type::bend_radius);

  const Measure& twist = named(measures, "twist");
  EXPECT_EQ(twist.unit, "rad");
  EXPECT_DOUBLE_EQ(twist.from, 0.1);
  EXPECT_DOUBLE_EQ(twist.to, 0.33);
  EXPECT_NEAR(*twist.upper, 20.0 * M_PI / 180.0, 1e-15);
}

TEST(SceneReader, measuresOfLoad) {
  const auto& measures = everything().measures;
  EXPECT_DOUBLE_EQ(*named(measures, "strain").upper, 0.05);
  EXPECT_EQ(named(measures, "strain").unit, "1");
  EXPECT_EQ(named(measures, "stress").cables, (Indices{0, 3}));
  EXPECT_DOUBLE_EQ(*named(measures, "stress").upper, 2e6);
  EXPECT_EQ(named(measures, "stress").unit, "Pa");

  const Measure& pull = named(measures, "pull");
  EXPECT_EQ(pull.type, Measure::Type::section_force);
  EXPECT_EQ(pull.unit, "N");
  EXPECT_DOUBLE_EQ(*pull.arc_length, 0.312);
  EXPECT_EQ(pull.axis, Axis::x);
  EXPECT_FALSE(named(measures, "moment").arc_length);
  EXPECT_FALSE(named(measures, "moment").axis);
  EXPECT_EQ(named(measures, "moment").unit, "N m");

  EXPECT_EQ(named(measures, "clip_pull").clip, 0U);
  EXPECT_EQ(named(measures, "clip_moment").clip, 5U);
  EXPECT_EQ(named(measures, "clip_moment").axis, Axis::z);
  EXPECT_EQ(named(measures, "slide").clip, 6U);
  EXPECT_EQ(named(measures, "energy").unit, "J");
  EXPECT_DOUBLE_EQ(*named(measures, "softness").lower, 100.0);
  EXPECT_EQ(named(measures, "softness").unit, "N/m");
}

TEST(SceneReader, measureTypesAreNamedAsInTheFile) {
  EXPECT_STREQ(toString(Measure::Type::distance), "distance");
  EXPECT_STREQ(toString(Measure::Type::section_moment), "section_moment");
  EXPECT_STREQ(toString(Measure::Type::eigenvalue), "eigenvalue");
}

TEST(SceneReader, motions) {
  const Motion& turn = named(everything().motions, "turn");
  EXPECT_EQ(turn.component, "engine");
  EXPECT_EQ(turn.samples.size(), 3U);
  const Motion& recorded = named(everything().motions, "recorded");
  EXPECT_TRUE(recorded.samples.empty());
  EXPECT_EQ(recorded.topic, "/engine/pose");
  EXPECT_EQ(recorded.frame, "engine");
  EXPECT_TRUE(std::filesystem::exists(recorded.path));
}

TEST(SceneReader, aMeshUsedTwiceIsReadOnce) {
  const TemporaryFile file("shared_mesh.yaml",
                           {"components:", "  - {name: a, mesh: package://test_data/meshes/tetrahedron.stl}",
                            "  - {name: b, mesh: package://test_data/meshes/tetrahedron.stl}"});
  const Scene scene = readScene(file.path(), findTestPackage);
  EXPECT_EQ(scene.components[0].visuals[0].mesh, scene.components[1].visuals[0].mesh);
}

// Every scene that the package ships.
TEST(SceneReader, shippedScenesAreSound) {
  std::size_t scenes = 0;
  for (const auto& entry :
       std::filesystem::directory_iterator(findTestPackage("cable_variation") + "/config")) {
    if (entry.path().extension() != ".yaml") continue;
    ++scenes;
    try {
      readScene(entry.path().string(), findTestPackage);
    } catch (const SceneError& error) {
      ADD_FAILURE() << error.what();
    }
  }
  EXPECT_GT(scenes, 0U);
}

TEST(SceneReader, motionsAreFoundWhateverTheCaseOfTheirExtension) {
  for (const char* const extension : {".TUM", ".Txt", ".tum"}) {
    const TemporaryFile motion(std::string("ride") + extension,
                               {"0 0 0 0 0 0 0 1", "1 0 0 0 0 0 0 1", "1 1 0 0 0 0 0 1"});
    const TemporaryFile file("ride.YAML",
                             {"components:", "  - {name: sled}", "motions:",
                              "  - {name: ride, component: sled, file: \"file://" + motion.path() + "\"}"});
    const Scene scene = readScene(file.path(), findTestPackage);
    EXPECT_EQ(scene.motions[0].samples.size(), 2U);
    ASSERT_EQ(scene.warnings.size(), 1U);
    EXPECT_EQ(toString(scene.warnings[0]),
              file.path() +
                  ":4: motion 'ride', file: 1 of its poses has the same time as the next one, and another "
                  "place; of 2 times the last pose counts");
  }
  for (const char* const extension : {".bag", ".BAG"})
    EXPECT_TRUE(isBag(std::string("package://a/b") + extension));
}

TEST(SceneReader, aMeshIsShownAsItIsRead) {
  const std::string folder = std::filesystem::temp_directory_path().string();
  const std::string name = std::to_string(getpid()) +
                           "_50% of M\xc3\xbc"
                           "ller's part #2.STL";
  std::filesystem::copy_file(findTestPackage("test_data") + "/meshes/tetrahedron.stl", folder + "/" + name);
  const std::string url =
      "file://" + folder + "/" + std::to_string(getpid()) + "_50%25%20of%20M%C3%BCller%27s%20part%20%232.STL";
  for (const std::string& address : {"file://" + folder + "/" + name, url}) {
    const TemporaryFile file("part.yaml", {"components:", "  - {name: part, mesh: \"" + address + "\"}"});
    const Scene scene = readScene(file.path(), findTestPackage);
    EXPECT_EQ(scene.components[0].visuals[0].mesh_resource, url);
    EXPECT_FALSE(scene.components[0].visuals[0].mesh->triangles.empty());
  }
  std::filesystem::remove(folder + "/" + name);
}

}  // namespace
}  // namespace cable_variation
