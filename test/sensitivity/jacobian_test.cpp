// Derivatives of measures against differences of re-solved designs: every measure by every kind of design
// variable, for every clip preset, kind of section and joint.

#include <cmath>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include <cable_variation/geometry/tube_distance/hausdorff.h>
#include <cable_variation/measures/cable_view.h>
#include <cable_variation/measures/measure_evaluation.h>
#include <cable_variation/scene/cable_property.h>

#include <equilibrium/case_table.h>
#include <measures/solved_scene.h>

namespace cable_variation::test {
namespace {

using Type = Measure::Type;

// The harness with its clips on a part that is located by six points and carries what holds clip C, a wall
// to measure to, and a variable of each kind.
Scene variedScene(const Harness& harness) {
  Scene scene = sceneOf(harness);
  Component carrier = boxPart("carrier", {0.02, 0.03, 0.02}, poseAt(0.12, -0.03, 0.05, {0.1, 0.2, 0.3}));
  carrier.locators = {{{0.05, 0.00, 0.0}, {0, 0, 1}},    {{-0.04, 0.03, 0.0}, {0, 0, 1}},
                      {{-0.03, -0.05, 0.01}, {0, 0, 1}}, {{0.04, 0.02, 0.0}, {0, 1, 0}},
                      {{-0.05, 0.02, 0.02}, {0, 1, 0}},  {{0.01, 0.03, 0.03}, {1, 0, 0}}};
  Component wall = boxPart("wall", {0.3, 0.01, 0.2}, poseAt(0.05, 0.16, 0.02, {0.05, -0.1, 0.2}));
  scene.components = {carrier, wall};
  const std::size_t held = harness.clips.size() - 1;  // clip C, or the only one
  scene.clip_mounts[held] = {"carrier", carrier.pose.inverse() * harness.clips[held].pose};

  auto& all = scene.design_variables;
  all.push_back(variable("shift", ClipTranslation{held, Axis::y}));
  all.push_back(variable("turn", ClipRotation{held, Axis::z}));
  all.push_back(variable("turn_of_A", ClipRotation{0, Axis::y}));
  all.push_back(variable("part_z", ComponentTranslation{0, Axis::z}));
  all.push_back(variable("part_rx", ComponentRotation{0, Axis::x}));
  all.push_back(variable("part_A2", LocatorDeviation{0, 1}));
  all.push_back(variable("wall_y", ComponentTranslation{1, Axis::y}));
  all.push_back(variable("wall_rz", ComponentRotation{1, Axis::z}));
  const Clip& clip = harness.clips[held];
  const bool inside = clip.arc_length > 0.0 && clip.arc_length < harness.cables[clip.cable].length;
  if (inside && !clip.constraint.slides)
    all.push_back(variable("clip_at", ClipArcLength{held}, clip.arc_length));
  for (std::size_t j = 0; j < harness.joints.size(); ++j) {
    all.push_back(
        variable("joint_at_" + std::to_string(j), BreakoutArcLength{j}, harness.joints[j].parent_arc_length));
  }
  using Property = CableProperty::Property;
  for (std::size_t c = 0; c < harness.cables.size(); ++c) {
    const Cable& cable = harness.cables[c];
    const auto add = [&](const std::string& name, const CableProperty& target) {
      all.push_back(variable(name + "_of_" + cable.name, target, propertyOf(cable, target.property)));
    };
    add("scaled_length", {c, Property::length, false, true});
    // beyond its last knot a profile has a kink
    if (cable.sections.size() == 1 && cable.rest_curvature.size() < 2) add("length", {c, Property::length});
    add("radius", {c, Property::radius});
    add("similar_radius", {c, Property::radius, true});
    add("EI", {c, Property::EI});
    add("GJ", {c, Property::GJ});
    add("EA", {c, Property::EA});
    add("density", {c, Property::density});
    if (!cable.rest_curvature.empty()) add("form", {c, Property::rest_curvature});
  }
  return scene;
}

// A measure of every type and form.
void addMeasures(Scene& scene) {
  std::vector<std::size_t> cables = allOf(scene.harness.cables.size());
  const double length = scene.harness.cables[0].length;
  const std::size_t held = scene.harness.clips.size() - 1;
  auto& all = scene.measures;
  const auto add = [&](Type type, const std::string& name, const auto& change) {
    all.push_back(measure(type, name, cables));
    change(all.back());
  };
  const auto as_is = [](Measure&) {};
  add(Type::distance, "to_wall", [](Measure& m) { m.component = 1; });
  add(Type::distance, "to_carrier", [](Measure& m) { m.component = 0; });
  // near a clip that rides on it: the closest place that counts is where the skipped stretch ends
  add(Type::distance, "to_carrier_near_clip", [](Measure& m) {
    m.component = 0;
    m.skip_near_clips = 0.09;
  });
  if (cables.size() > 1) {
    for (const double skip : {0.0, 0.03, 0.08}) {
      add(Type::distance, "to_branch_skip_" + std::to_string(skip), [&](Measure& m) {
        m.cables = {0};
        m.other_cables = {1};
        m.skip_near_joints = skip;
      });
    }
  }
  add(Type::similarity, "similarity", as_is);
  add(Type::similarity, "surface_similarity", [](Measure& m) { m.surface = true; });
  for (const double share : {0.31, 0.77, 1.0}) {
    add(Type::position, "position_" + std::to_string(share), [&](Measure& m) {
      m.cables = {0};
      m.arc_length = share * length;
      m.direction = Eigen::Vector3d(0.6, -0.64, 0.48);
    });
  }
  add(Type::bend_radius, "bend_radius", as_is);
  add(Type::strain, "strain", as_is);
  add(Type::stress, "stress", as_is);
  for (const Type type : {Type::section_force, Type::section_moment}) {
    const std::string name = type == Type::section_force ? "force" : "moment";
    add(type, name, as_is);
    add(type, name + "_z", [](Measure& m) { m.axis = Axis::z; });
    add(type, name + "_at", [&](Measure& m) {
      m.cables = {0};
      m.arc_length = 0.63 * length;
    });
    add(type, name + "_y_at", [&](Measure& m) {
      m.cables = {0};
      m.arc_length = 0.63 * length;
      m.axis = Axis::y;
    });
  }
  add(Type::twist, "twist", [&](Measure& m) {
    m.cables = {0};
    m.to = length;
  });
  add(Type::twist, "twist_between", [&](Measure& m) {
    m.cables = {0};
    m.from = 0.11 * length;
    m.to = 0.71 * length;
  });
  for (const Type type : {Type::clip_force, Type::clip_moment}) {
    const std::string name = type == Type::clip_force ? "clip_force" : "clip_moment";
    add(type, name, [](Measure& m) { m.clip = 0; });
    add(type, name + "_z_of_C", [&](Measure& m) {
      m.clip = held;
      m.axis = Axis::z;
    });
  }
  for (const double from : {0.0, 0.13}) {
    add(Type::route_deviation, "route_from_" + std::to_string(from), [&](Measure& m) {
      m.cables = {0};
      m.from = from * length;
      m.to = from > 0.0 ? 0.83 * length : length;
      m.route = {{0.01, 0.02, 0.01}, {0.07, -0.03, 0.04}, {0.15, 0.03, 0.06}, {0.2, 0.01, -0.02}};
    });
  }
  if (scene.harness.clips[held].constraint.slides)
    add(Type::slide, "slide", [&](Measure& m) { m.clip = held; });
  add(Type::energy, "energy", as_is);
}

Eigen::MatrixXd jacobianOf(const Scene& scene, const Solved& solved, EquilibriumSolver& solver,
                           const MeasureEvaluator& evaluator, const std::vector<MeasureValue>& values) {
  const std::vector<DesignRate> design = designRates(scene, {}, {}, allOf(scene.design_variables.size()));
  std::vector<HarnessRate> harness_rates;
  for (const DesignRate& rate : design) harness_rates.push_back(rate.harness);
  return evaluator.jacobian(solved.view(), allOf(scene.measures.size()), values, design,
                            solver.differentiate(harness_rates));
}

// Differences of fourth order of all measures by one variable.
struct Slopes {
  std::vector<double> slope;
  std::vector<bool> jumps;  ///< the worst place is another one in some of the designs
};
Slopes slopesOf(const Scene& scene, const DesignVariable& variable, double step, EquilibriumSolver& solver,
                const MeasureEvaluator& evaluator, const std::vector<MeasureValue>& values) {
  const auto at = [&](double steps) {
    EquilibriumSolver from = solver;
    const Solved solved = solveAt(scene, {{variable.name, variable.nominal + steps * step}}, from);
    EXPECT_TRUE(solved.equilibrium.converged()) << solved.equilibrium.message;
    return evaluator.evaluate(solved.view(), allOf(scene.measures.size()), &values);
  };
  const auto a = at(1.0), b = at(-1.0), c = at(2.0), d = at(-2.0);
  Slopes result;
  for (std::size_t m = 0; m < values.size(); ++m) {
    result.slope.push_back((8.0 * (a[m].value - b[m].value) - (c[m].value - d[m].value)) / (12.0 * step));
    const auto along = [](const MeasureValue& value) {
      return static_cast<double>(value.trace.place.piece) + value.trace.place.t;
    };
    bool jumps = false;
    for (const auto* there : {&a[m], &b[m], &c[m], &d[m]}) {
      jumps = jumps || !there->unique || there->cable != values[m].cable ||
              there->trace.from_nominal != values[m].trace.from_nominal ||
              std::abs(along(*there) - along(values[m])) > 0.05;
    }
    result.jumps.push_back(jumps);
  }
  return result;
}

// Of loads, below which a value counts as zero: the stiff cables' rounding.
double smallest(const Measure& measure) {
  switch (measure.type) {
    case Type::section_force:
    case Type::clip_force:
      return 0.2;  // [N]
    case Type::section_moment:
    case Type::clip_moment:
      return 0.01;  // [N m]
    default:
      return 0.0;
  }
}

class Jacobian : public testing::TestWithParam<NamedHarness> {};

TEST_P(Jacobian, IsTheSlopeOfResolvedDesigns) {
  Scene scene = variedScene(GetParam().harness);
  addMeasures(scene);
  EquilibriumSolver solver(fixedGridOptions());
  // shapes are compared with that of another design: away from it similarity is smooth
  DesignValues other;
  other["shift"] = 0.006;
  other["turn_of_A"] = 0.05;
  other["similar_radius_of_" + scene.harness.cables[0].name] =
      1.1 * propertyOf(scene.harness.cables[0], CableProperty::Property::radius);
  EquilibriumSolver aside(fixedGridOptions());
  const Solved compared = solveAt(scene, other, aside);
  ASSERT_TRUE(compared.equilibrium.converged()) << compared.equilibrium.message;
  const Solved nominal = solveAt(scene, {}, solver);
  ASSERT_TRUE(nominal.equilibrium.converged()) << nominal.equilibrium.message;
  const MeasureEvaluator evaluator(scene, compared.view());
  const std::vector<std::size_t> measures = allOf(scene.measures.size());
  const std::vector<MeasureValue> values = evaluator.evaluate(nominal.view(), measures);

  const Eigen::MatrixXd jacobian = jacobianOf(scene, nominal, solver, evaluator, values);

  int compared_slopes = 0, jumped = 0;
  for (std::size_t v = 0; v < scene.design_variables.size(); ++v) {
    const DesignVariable& variable = scene.design_variables[v];
    SCOPED_TRACE(variable.name);
    const double unit = variable.nominal != 0.0 ? std::abs(variable.nominal) : 1.0;
    const Slopes fine = slopesOf(scene, variable, 3e-5 * unit, solver, evaluator, values);
    const Slopes coarse = slopesOf(scene, variable, 1e-4 * unit, solver, evaluator, values);
    for (std::size_t m = 0; m < measures.size(); ++m) {
      if (!values[m].unique) continue;
      // differences that disagree with each other cannot tell: the place is in a sharp bend of the measure
      const bool disagree =
          std::abs(fine.slope[m] - coarse.slope[m]) > 1e-5 * std::abs(coarse.slope[m]) &&
          std::abs(fine.slope[m] - coarse.slope[m]) * unit > 1e-5 * std::abs(values[m].value);
      if (fine.jumps[m] || coarse.jumps[m] || disagree) {
        ++jumped;
        continue;
      }
      ++compared_slopes;
      const double rate = jacobian(static_cast<Eigen::Index>(m), static_cast<Eigen::Index>(v));
      const double off = std::min(std::abs(rate - fine.slope[m]), std::abs(rate - coarse.slope[m]));
      // 1e-6 of the derivative; and what rounding leaves of values, some 1e-12 of them, over the step
      const double noise = 3e-7 * std::max(std::abs(values[m].value), smallest(scene.measures[m])) / unit;
      EXPECT_LE(off, 1e-6 * std::abs(rate) + noise)
          << scene.measures[m].name << " of " << values[m].value << " at " << values[m].arc_length
          << ": derivative " << rate << ", differences " << fine.slope[m] << " and " << coarse.slope[m];
    }
  }
  // a place that is nearly the worst may become it within the differences
  EXPECT_LE(jumped, compared_slopes / 8);
}

// The largest Hausdorff distance of a cable in two shapes, more exact than the measure needs.
double furthest(const Solved& a, const Solved& b, bool surface) {
  double largest = 0.0;
  for (std::size_t i = 0; i < a.harness.cables.size(); ++i) {
    const Centreline one = centrelineOf(a.harness.cables[i], a.equilibrium.shapes[i]);
    const Centreline other = centrelineOf(b.harness.cables[i], b.equilibrium.shapes[i]);
    constexpr double kAccuracy = 1e-11;
    largest = std::max(largest, surface ? surfaceHausdorff(one, other, kAccuracy).distance
                                        : curveHausdorff(one, other, kAccuracy).distance);
  }
  return largest;
}

TEST_P(Jacobian, SimilarityAtTheNominalHasTheLimitOfItsDifferences) {
  Scene scene = variedScene(GetParam().harness);
  const std::vector<std::size_t> cables = allOf(scene.harness.cables.size());
  scene.measures = {measure(Type::similarity, "similarity", cables),
                    measure(Type::similarity, "surface_similarity", cables)};
  scene.measures[1].surface = true;
  EquilibriumSolver solver(fixedGridOptions());
  const Solved nominal = solveAt(scene, {}, solver);
  const MeasureEvaluator evaluator(scene, nominal.view());
  const std::vector<std::size_t> measures = allOf(2);
  const std::vector<MeasureValue> values = evaluator.evaluate(nominal.view(), measures);
  const Eigen::MatrixXd jacobian = jacobianOf(scene, nominal, solver, evaluator, values);
  for (std::size_t v = 0; v < scene.design_variables.size(); ++v) {
    const DesignVariable& variable = scene.design_variables[v];
    for (std::size_t m = 0; m < 2; ++m) {
      const double rate = jacobian(static_cast<Eigen::Index>(m), static_cast<Eigen::Index>(v));
      const double unit = variable.nominal != 0.0 ? std::abs(variable.nominal) : 1.0;
      // some 5 um of shift, and no more than 2 % or 20 mm or mrad of a variable
      const double step = std::min(5e-6 / rate, 2e-2 * unit);
      if (rate * step < 2.5e-6) continue;  // then rounding of the shapes shows in the quotient
      for (const double sign : {1.0, -1.0}) {
        const auto quotient = [&](double by) {
          EquilibriumSolver from = solver;
          const Solved solved = solveAt(scene, {{variable.name, variable.nominal + sign * by}}, from);
          return furthest(nominal, solved, m == 1) / by;
        };
        // their limit at a step of zero, by Richardson
        const double limit =
            (8.0 * quotient(0.25 * step) - 6.0 * quotient(0.5 * step) + quotient(step)) / 3.0;
        // a surface whose radius varies has no closed form, but a quotient of its own
        const bool varying = m == 1 && scene.harness.cables[0].sections.size() > 1;
        EXPECT_NEAR(limit, rate, (varying ? 2e-3 : 1e-4) * rate)
            << variable.name << ", " << scene.measures[m].name << ", " << sign;
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Sections, Jacobian, testing::ValuesIn(harnessPerSection()), harnessName);
INSTANTIATE_TEST_SUITE_P(Clips, Jacobian, testing::ValuesIn(harnessPerClip()), harnessName);
INSTANTIATE_TEST_SUITE_P(Joints, Jacobian, testing::ValuesIn(harnessPerJoint()), harnessName);

}  // namespace
}  // namespace cable_variation::test
