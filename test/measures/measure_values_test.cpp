// Values of measures against closed forms.

#include <cmath>
#include <stdexcept>

#include <gtest/gtest.h>

#include <measures/solved_scene.h>

namespace cable_variation::test {
namespace {

using Eigen::Vector3d;
using Type = Measure::Type;

const Material kPlastic{2e8, 0.25, 1500.0};
constexpr double kLength = 0.3, kRadius = 0.005;
const Vector3d kNoGravity = Vector3d::Zero();

// Solves a scene and evaluates its measures, similarity to the same shape.
struct Evaluated {
  Scene scene;
  Solved solved;
  std::vector<MeasureValue> values;

  Evaluated(const Harness& harness, const std::vector<Measure>& measures,
            const std::vector<Component>& components = {})
      : scene(sceneOf(harness)) {
    scene.measures = measures;
    scene.components = components;
    EquilibriumOptions options;
    options.accuracy = 1e-7;
    EquilibriumSolver solver(options);
    solved = solveAt(scene, {}, solver);
    EXPECT_TRUE(solved.equilibrium.converged()) << solved.equilibrium.message;
    values = MeasureEvaluator(scene, solved.view()).evaluate(solved.view(), allOf(measures.size()));
  }
};

Measure at(Measure measure, double arc_length) {
  measure.arc_length = arc_length;
  return measure;
}
Measure along(Measure measure, Axis axis) {
  measure.axis = axis;
  return measure;
}
Measure between(double from, double to) {
  Measure twist = measure(Type::twist, "twist");
  twist.from = from;
  twist.to = to;
  return twist;
}

Harness cantileverWith(const Section& section, const Vector3d& force, const Vector3d& moment) {
  Harness harness = cantilever(uniformCable(kLength, section), kNoGravity);
  harness.loads = {loadAt(0, kLength, force, moment)};
  return harness;
}

TEST(MeasureValues, BentByAMomentIntoAnArc) {
  const Section section = solidSection(kRadius, kPlastic);
  const double kMoment = 0.3;
  Measure height = at(measure(Type::position, "height"), kLength);
  height.direction = Vector3d::UnitY();
  const Evaluated arc(
      cantileverWith(section, kNoGravity, {0.0, 0.0, kMoment}),
      {measure(Type::bend_radius, "r"), measure(Type::strain, "e"), measure(Type::stress, "s"),
       measure(Type::section_moment, "m"), along(at(measure(Type::section_moment, "mz"), 0.1), Axis::z),
       measure(Type::clip_moment, "c"), measure(Type::energy, "w"), height, between(0.0, kLength)});
  const double radius = section.EI_z / kMoment;
  // the centreline between points is a quintic, whose curvature is less exact than all else
  const double expected[] = {radius,
                             kRadius / radius,
                             kPlastic.young_modulus * kRadius / radius,
                             kMoment,
                             kMoment,
                             kMoment,
                             0.5 * kMoment * kMoment * kLength / section.EI_z,
                             radius * (1.0 - std::cos(kLength / radius)),
                             0.0};
  for (std::size_t i = 0; i < arc.values.size(); ++i)
    EXPECT_NEAR(arc.values[i].value, expected[i], (i == 0 ? 2e-6 : 1e-7) * std::max(expected[i], 1e-3))
        << arc.scene.measures[i].name;
}

TEST(MeasureValues, PulledAndTwisted) {
  const Section section = hoseSection(kRadius, 0.003, kPlastic);
  const double kForce = 20.0, kTorque = 0.05;
  const Evaluated bar(
      cantileverWith(section, {kForce, 0.0, 0.0}, {kTorque, 0.0, 0.0}),
      {measure(Type::strain, "e"), measure(Type::stress, "s"), measure(Type::section_force, "f"),
       along(measure(Type::section_moment, "mx"), Axis::x), between(0.05, 0.25),
       along(measure(Type::clip_force, "c"), Axis::x), measure(Type::clip_moment, "cm")});
  const double strain = kForce / section.EA, torsion = kTorque / section.GJ;
  const double expected[] = {strain,
                             std::hypot(kPlastic.young_modulus * strain,
                                        std::sqrt(3.0) * kPlastic.shearModulus() * kRadius * torsion),
                             kForce,
                             kTorque,
                             0.2 * torsion,
                             -kForce,  // of the clip on the cable
                             kTorque};
  for (std::size_t i = 0; i < bar.values.size(); ++i)
    EXPECT_NEAR(bar.values[i].value, expected[i], 1e-8 * std::abs(expected[i])) << bar.scene.measures[i].name;
}

TEST(MeasureValues, TwistOfAStepAddsUp) {
  Cable cable = uniformCable(kLength, solidSection(0.004, kPlastic));
  cable.sections = {{0.0, solidSection(0.004, kPlastic)},
                    {0.12, solidSection(0.004, kPlastic)},
                    {0.12, solidSection(0.006, kPlastic)},
                    {kLength, solidSection(0.006, kPlastic)}};
  Harness harness = cantilever(cable, kNoGravity);
  const double kTorque = 0.05;
  harness.loads = {loadAt(0, kLength, kNoGravity, {kTorque, 0.0, 0.0})};
  const Evaluated bar(harness, {between(0.02, 0.2), measure(Type::stress, "s")});
  const double thin = kTorque / cable.sections[0].section.GJ, thick = kTorque / cable.sections[3].section.GJ;
  EXPECT_NEAR(bar.values[0].value, 0.1 * thin + 0.08 * thick, 1e-10);
  EXPECT_NEAR(bar.values[1].value, std::sqrt(3.0) * kPlastic.shearModulus() * 0.004 * thin, 1.0);
  EXPECT_LE(bar.values[1].arc_length, 0.12);
}

TEST(MeasureValues, RectangleIsStrainedMostAtItsCorner) {
  const Section section = rectangleSection(0.012, 0.006, kPlastic);
  const Vector3d kMoment(0.0, 0.004, 0.009);  // small: bending about both axes superposes
  const Evaluated bar(cantileverWith(section, kNoGravity, kMoment), {measure(Type::strain, "e")});
  const double corner = 0.003 * kMoment.y() / section.EI_y + 0.006 * kMoment.z() / section.EI_z;
  // the section turns by up to 5e-3 rad, which mixes the moments' components
  EXPECT_NEAR(bar.values[0].value, corner, 2e-2 * corner);
  // at the clamp it has not turned yet
  const ShapePoint& clamp = bar.solved.equilibrium.shapes[0].points.front();
  EXPECT_NEAR(0.003 * std::abs(clamp.curvature.y()) + 0.006 * std::abs(clamp.curvature.z()), corner,
              1e-8 * corner);
}

TEST(MeasureValues, HangingCableBearsWhatIsBelow) {
  const Section section = solidSection(kRadius, kPlastic);
  Harness harness = cantilever(uniformCable(kLength, section));
  harness.clips[0].pose = poseAt(0, 0, 0, {0.0, M_PI / 2.0, 0.0});  // its x axis down
  const double weight = 9.81 * section.mass_per_length;
  const Evaluated hanging(
      harness, {at(measure(Type::section_force, "f"), 0.113), measure(Type::section_force, "top"),
                measure(Type::clip_force, "clip"), along(measure(Type::clip_force, "clip_x"), Axis::x)});
  EXPECT_NEAR(hanging.values[0].value, weight * (kLength - 0.113), 1e-9);
  EXPECT_NEAR(hanging.values[1].value, weight * kLength, 1e-9);
  EXPECT_NEAR(hanging.values[1].arc_length, 0.0, 1e-9);
  EXPECT_NEAR(hanging.values[2].value, weight * kLength, 1e-9);
  EXPECT_NEAR(hanging.values[3].value, -weight * kLength, 1e-9);
}

TEST(MeasureValues, DistancesOfAStraightCable) {
  Harness harness = cantilever(uniformCable(kLength, solidSection(kRadius, kPlastic)), kNoGravity);
  harness.cables.push_back(uniformCable(0.1, solidSection(0.003, kPlastic), "other"));
  harness.clips.push_back(clipOn(1, "B", 0.0, fixedClip(), poseAt(0.12, 0.05, 0.02, {0.0, 0.0, M_PI / 2.0})));
  Measure to_box = measure(Type::distance, "box", {0, 1}), near_clip = to_box;
  to_box.component = near_clip.component = 0;
  near_clip.skip_near_clips = 0.04;
  Measure to_other = measure(Type::distance, "other");
  to_other.other_cables = {1};
  Scene scene = sceneOf(harness);
  scene.components = {boxPart("box", {0.02, 0.02, 0.02}, poseAt(0.0, 0.0, 0.06))};
  scene.clip_mounts[0] = {"box", scene.components[0].pose.inverse() * harness.clips[0].pose};
  scene.measures = {to_box, near_clip, to_other};
  EquilibriumSolver solver;
  const Solved solved = solveAt(scene, {}, solver);
  const auto values = MeasureEvaluator(scene, solved.view()).evaluate(solved.view(), allOf(3));
  // the box's lower face is at z = 0.05, x up to 0.01
  EXPECT_NEAR(values[0].value, 0.05 - kRadius, 1e-7);
  EXPECT_NEAR(values[1].value, std::hypot(0.03, 0.05) - kRadius, 1e-7);  // from s = 0.04 on
  EXPECT_NEAR(values[1].arc_length, 0.04, 1e-6);
  EXPECT_TRUE(values[1].other.isApprox(Vector3d(0.01, values[1].other.y(), 0.05), 1e-5));
  EXPECT_NEAR(values[2].value, std::hypot(0.05, 0.02) - kRadius - 0.003, 1e-7);
  EXPECT_NEAR(values[2].arc_length, 0.12, 1e-6);
  // points are on the surfaces
  EXPECT_NEAR((values[2].point - values[2].other).norm(), values[2].value, 1e-9);
}

TEST(MeasureValues, SimilarityOfAShiftedCableIsTheShift) {
  const Harness harness = caseH();
  Scene scene = sceneOf(harness);
  scene.measures = {measure(Type::similarity, "curve"), measure(Type::similarity, "surface")};
  scene.measures[1].surface = true;
  EquilibriumSolver solver;
  const Solved nominal = solveAt(scene, {}, solver);
  const Vector3d shift(0.003, -0.002, 0.001);
  Solved moved = nominal;
  for (ShapePoint& point : moved.equilibrium.shapes[0].points) point.pose.position += shift;
  const MeasureEvaluator evaluator(scene, nominal.view());
  EXPECT_LT(evaluator.evaluate(nominal.view(), {0})[0].value, 1e-12);
  for (const MeasureValue& value : evaluator.evaluate(moved.view(), {0, 1})) {
    // no place is further away than the shift; the ends are as far unless the curve passes by
    EXPECT_LE(value.value, shift.norm() + 1e-9);
    EXPECT_GE(value.value, 0.95 * shift.norm());
  }
}

TEST(MeasureEvaluator, NamesWhatIsMissing) {
  const Harness harness = cantilever(uniformCable(kLength, solidSection(kRadius, kPlastic)), kNoGravity);
  Scene scene = sceneOf(harness);
  scene.components = {boxPart("box", {0.02, 0.02, 0.02}, poseAt(0.0, 0.0, 0.06))};
  scene.measures = {measure(Type::distance, "D")};
  scene.measures[0].component = 0;
  EquilibriumSolver solver;
  Solved solved = solveAt(scene, {}, solver);
  const MeasureEvaluator evaluator(scene, solved.view());
  EXPECT_THROW(evaluator.evaluate(solved.view(), {1}), std::invalid_argument);
  solved.components.clear();
  try {
    evaluator.evaluate(solved.view(), {0});
    FAIL() << "no pose, no distance";
  } catch (const std::invalid_argument& error) {
    EXPECT_NE(std::string(error.what()).find("box"), std::string::npos);
  }
  scene.components[0].visuals.clear();
  EXPECT_THROW(MeasureEvaluator(scene, solved.view()), std::invalid_argument);
}

}  // namespace
}  // namespace cable_variation::test
