// What the table of traits says of measures, against their values.

#include <cable_variation/measures/measure_functions.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include <gtest/gtest.h>

#include <cable_variation/scene/measure_traits.h>
#include <measures/solved_scene.h>

namespace cable_variation::test {
namespace {

using Subject = MeasureTraits::Subject;
using Worse = MeasureTraits::Worse;

// Two unlike cables that sag above a box, the second nearer to it.
Scene sceneOfTwo() {
  const Section section = solidSection(0.003, {1e8, 0.25, 1500.0});
  Harness harness = clamped(uniformCable(0.25, section, "short"), poseAt(0.24, 0.0, 0.0));
  harness.cables.push_back(uniformCable(0.3, section, "long"));
  harness.clips.push_back(clipOn(1, "C", 0.0, fixedClip(), poseAt(0.0, 0.1, -0.02)));
  harness.clips.push_back(clipOn(1, "D", 0.3, fixedClip(), poseAt(0.24, 0.1, -0.02)));
  Scene scene = sceneOf(harness);
  scene.components = {boxPart("box", {0.4, 0.4, 0.02}, poseAt(0.12, 0.0, -0.2))};
  return scene;
}

bool isOfContact(const MeasureTraits& traits) {
  return traits.type == Measure::Type::contact_force || traits.type == Measure::Type::contact_length;
}

// A measure of the type that needs no more than these cables, a clip, and the box.
Measure measureOf(const MeasureTraits& traits, std::vector<std::size_t> cables) {
  Measure made = measure(traits.type, traits.name, std::move(cables));
  if (traits.clearance || isOfContact(traits)) made.component = 0;
  made.arc_length = traits.subject == Subject::cable ? std::optional<double>(0.1) : std::nullopt;
  made.direction = Eigen::Vector3d::UnitZ();
  made.to = 0.2;
  made.route = {{0.0, 0.05, 0.1}, {0.2, 0.05, 0.1}};
  return made;
}

TEST(MeasureFunctions, everyTypeHasItsOwn) {
  for (const MeasureTraits& traits : measureTraits()) {
    EXPECT_EQ(functionsOf(traits.type).type, traits.type);
    EXPECT_NE(functionsOf(traits.type).value, nullptr) << traits.name;
    EXPECT_NE(functionsOf(traits.type).rate, nullptr) << traits.name;
  }
}

// Values of every type, over both cables, the first and the second, told by the traits what they are of.
TEST(MeasureFunctions, valuesAreOfWhatTheTraitsSay) {
  Scene scene = sceneOfTwo();
  for (const MeasureTraits& traits : measureTraits()) {
    for (const auto& cables : std::vector<std::vector<std::size_t>>{{0, 1}, {0}, {1}})
      scene.measures.push_back(measureOf(traits, cables));
  }
  EquilibriumOptions options;
  options.accuracy = 1e-6;
  EquilibriumSolver solver(options);
  const Solved sagging = solveAt(scene, {}, solver);
  ASSERT_TRUE(sagging.equilibrium.converged()) << sagging.equilibrium.message;
  Scene weightless = scene;
  weightless.harness.gravity.setZero();
  const Solved nominal = solveAt(weightless, {}, solver);
  ASSERT_TRUE(nominal.equilibrium.converged()) << nominal.equilibrium.message;

  const std::vector<std::size_t> all = allOf(scene.measures.size());
  const MeasureEvaluator evaluator(scene, nominal.view());
  const std::vector<MeasureValue> values = evaluator.evaluate(sagging.view(), all);
  const std::vector<MeasureValue> same = evaluator.with(scene, sagging.view()).evaluate(sagging.view(), all);
  for (std::size_t i = 0; i < measureTraits().size(); ++i) {
    const MeasureTraits& traits = measureTraits()[i];
    const double both = values[3 * i].value, first = values[3 * i + 1].value,
                 second = values[3 * i + 2].value;
    EXPECT_TRUE(std::isfinite(both)) << traits.name;
    if (isOfContact(traits)) {  // nothing touches here: test/contact
      EXPECT_EQ(both, 0.0) << traits.name;
      EXPECT_FALSE(values[3 * i].has_place) << traits.name;
      continue;
    }
    EXPECT_EQ(values[3 * i].has_place, traits.subject != Subject::harness) << traits.name;
    if (traits.subject == Subject::cables) {
      EXPECT_NE(first, second) << traits.name << ": the cables are alike, nothing is seen of the worse";
      const double worse = traits.worse == Worse::smaller ? std::min(first, second) : std::max(first, second);
      EXPECT_EQ(both, worse) << traits.name;
    } else if (traits.subject == Subject::cable) {
      EXPECT_EQ(both, first) << traits.name << " is of the first cable";
    } else {
      EXPECT_EQ(both, second) << traits.name << " has nothing to do with cables";
    }
    EXPECT_EQ(same[3 * i].value != both, traits.from_nominal) << traits.name;
  }
}

}  // namespace
}  // namespace cable_variation::test
