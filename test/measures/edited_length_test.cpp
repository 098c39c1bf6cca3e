// Measures of a design whose length was edited are those of the scene with that length as a value.

#include <random>

#include <gtest/gtest.h>

#include <cable_variation/scene/design.h>

#include <measures/solved_scene.h>

namespace cable_variation::test {
namespace {

using Eigen::Vector3d;
using Type = Measure::Type;

constexpr double kLength = 0.3;

std::vector<MeasureValue> valuesOf(const Scene& scene, const DesignValues& values) {
  EquilibriumOptions options;
  options.accuracy = 1e-7;
  EquilibriumSolver solver(options);
  const Solved solved = solveAt(scene, values, solver);
  EXPECT_TRUE(solved.equilibrium.converged()) << solved.equilibrium.message;
  return MeasureEvaluator(scene, solved.view()).evaluate(solved.view(), allOf(scene.measures.size()));
}

Scene sceneWithMeasures(const Harness& harness, bool clips_scale) {
  Scene scene = sceneOf(harness);
  CableProperty length{0, CableProperty::Property::length};
  length.clips_scale = clips_scale;
  scene.design_variables = {variable("L", length, kLength)};
  for (const double place : {0.0, 0.1, kLength}) {
    Measure height = measure(Type::position, "height");
    height.arc_length = place;
    height.direction = Vector3d(0.6, 0.0, 0.8);
    Measure force = measure(Type::section_force, "force"), moment = measure(Type::section_moment, "moment");
    force.arc_length = moment.arc_length = place;
    Measure twist = measure(Type::twist, "twist");
    twist.from = std::min(place, 0.05);
    twist.to = std::max(place, 0.06);
    scene.measures.insert(scene.measures.end(), {height, force, moment, twist});
  }
  return scene;
}

TEST(EditedLength, EndsStayEnds) {
  std::mt19937 random(4);
  std::uniform_real_distribution<double> share(-1.0, 1.0);
  const Cable cable = uniformCable(kLength, solidSection(0.005, {2e8, 0.25, 1500.0}));
  const Vector3d gravity(0.0, 0.0, -9.81);
  Harness loaded = cantilever(cable, gravity);
  loaded.loads = {loadAt(0, kLength, {0.0, 0.2, 0.1}, Vector3d::Zero())};
  for (const Harness& harness : {loaded, clamped(cable, poseAt(0.26, 0.02, 0.0, {0.4, 0.0, 0.0}), gravity)}) {
    for (const bool clips_scale : {false, true}) {
      const Scene scene = sceneWithMeasures(harness, clips_scale);
      Design design;
      design.scene = scene;
      for (int i = 0; i < 4; ++i) {  // one edit after another
        const double length = kLength + 0.02 * share(random);
        setNominal(design, "L", length);
        const auto expected = valuesOf(scene, {{"L", length}}), edited = valuesOf(design.scene, {});
        for (std::size_t k = 0; k < expected.size(); ++k) {
          EXPECT_NEAR(edited[k].value, expected[k].value, 1e-6 + 1e-4 * std::abs(expected[k].value))
              << scene.measures[k].name << " at " << scene.measures[k].arc_length.value_or(-1.0)
              << ", length " << length;
        }
      }
    }
  }
}

}  // namespace
}  // namespace cable_variation::test
