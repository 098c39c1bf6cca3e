// Derivatives of equilibria against differences of re-solved ones, for every section, clip preset and joint,
// and everything about a harness that a variable can change.

#include <algorithm>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include <equilibrium/case_table.h>

namespace cable_variation::test {
namespace {

struct NamedRate {
  std::string name;
  HarnessRate rate;
};

CableRate rateOfCable(std::size_t cable) {
  CableRate rate;
  rate.cable = cable;
  return rate;
}

void addCableRates(const Harness& harness, std::size_t index, std::vector<NamedRate>& rates) {
  const Cable& cable = harness.cables[index];
  const auto add = [&](const std::string& name, const CableRate& rate) {
    rates.push_back({name + "_of_" + cable.name, {}});
    rates.back().rate.cables = {rate};
  };
  CableRate bending = rateOfCable(index), torsion = bending, stretch = bending, mass = bending,
            form = bending;
  bending.stiffness.tail<2>().setOnes();
  torsion.stiffness[3] = 1.0;
  stretch.stiffness.head<3>().setOnes();
  mass.mass = 1.0;
  form.rest_curvature = 1.0;
  add("EI", bending);
  add("GJ", torsion);
  add("EA", stretch);
  add("density", mass);
  if (!cable.rest_curvature.empty()) add("form", form);
}

void addLengthRates(const Harness& harness, std::size_t index, std::vector<NamedRate>& rates) {
  const Cable& cable = harness.cables[index];
  const auto add = [&](const std::string& name, bool scale) {
    // per length: a unit of the variable doubles it
    CableRate length = rateOfCable(index);
    length.length = cable.length;
    if (scale) {
      length.knots = 1.0;
      length.rest_curvature = -1.0;
    }
    NamedRate named{name + "_of_" + cable.name, {}};
    const auto visit = [&](std::size_t on, double arc_length, std::size_t which,
                           std::vector<std::pair<std::size_t, double>>& list) {
      if (on == index && (scale || arc_length >= cable.length)) list.emplace_back(which, arc_length);
    };
    for (std::size_t i = 0; i < harness.clips.size(); ++i) {
      visit(harness.clips[i].cable, harness.clips[i].arc_length, i, named.rate.clip_arc_lengths);
    }
    for (std::size_t i = 0; i < harness.joints.size(); ++i) {
      visit(harness.joints[i].parent, harness.joints[i].parent_arc_length, i, named.rate.parent_arc_lengths);
      visit(harness.joints[i].child, harness.joints[i].child_arc_length, i, named.rate.child_arc_lengths);
    }
    for (std::size_t i = 0; i < harness.loads.size(); ++i) {
      visit(harness.loads[i].cable, harness.loads[i].arc_length, i, named.rate.load_arc_lengths);
    }
    named.rate.cables = {length};
    rates.push_back(named);
  };
  add("scaled_length", true);
  // beyond its last knot a profile has a kink
  if (cable.sections.size() == 1 && cable.rest_curvature.size() < 2) add("length", false);
}

std::vector<NamedRate> ratesFor(const Harness& harness) {
  std::vector<NamedRate> rates;
  for (std::size_t i = 0; i < harness.clips.size(); ++i) {
    const Clip& clip = harness.clips[i];
    rates.push_back({"shift_of_" + clip.name, {}});
    rates.back().rate.clip_frames = {{i, {{0.2, -0.1, 0.15}, Eigen::Vector3d::Zero()}}};
    rates.push_back({"turn_of_" + clip.name, {}});
    rates.back().rate.clip_frames = {{i, {Eigen::Vector3d::Zero(), {0.5, 0.7, -0.6}}}};
    const bool inside = clip.arc_length > 0.0 && clip.arc_length < harness.cables[clip.cable].length;
    if (inside && !clip.constraint.slides) {
      rates.push_back({"arc_length_of_" + clip.name, {}});
      rates.back().rate.clip_arc_lengths = {{i, 0.2}};
    }
  }
  for (std::size_t i = 0; i < harness.joints.size(); ++i) {
    rates.push_back({"arc_length_of_" + harness.joints[i].name, {}});
    rates.back().rate.parent_arc_lengths = {{i, 0.2}};
  }
  for (std::size_t i = 0; i < harness.cables.size(); ++i) {
    addCableRates(harness, i, rates);
    addLengthRates(harness, i, rates);
  }
  return rates;
}

// A field of an equilibrium as one list of numbers, and the same of its rate.
struct Field {
  const char* name;
  std::vector<double> (*of)(const Equilibrium&);
  std::vector<double> (*rate)(const EquilibriumRate&);
};

template <class Each, class Visit>
void append(const std::vector<Each>& all, const Visit& visit, std::vector<double>& values) {
  for (const Each& each : all) {
    const Eigen::Vector3d v = visit(each);
    values.insert(values.end(), v.data(), v.data() + 3);
  }
}

template <class Visit>
std::vector<double> ofPoints(const Equilibrium& equilibrium, const Visit& visit) {
  std::vector<double> values;
  for (const CableShape& shape : equilibrium.shapes) append(shape.points, visit, values);
  return values;
}

template <class Visit>
std::vector<double> ofPoints(const EquilibriumRate& rate, const Visit& visit) {
  std::vector<double> values;
  for (const std::vector<ShapePointRate>& points : rate.shapes) append(points, visit, values);
  return values;
}

template <class Of, class Visit>
std::vector<double> ofReactions(const Of& of, const Visit& visit) {
  std::vector<double> values;
  append(of.clip_reactions, visit, values);
  return values;
}

// The same expression of a point p, or of a clip's reaction r, of an equilibrium and of its rate; where they
// are called differently, one for each.
#define SHAPE_FIELD(name, of_point, of_rate)                                                      \
  {                                                                                               \
    name,                                                                                         \
        [](const Equilibrium& e) {                                                                \
          return ofPoints(e, [](const ShapePoint& p) -> Eigen::Vector3d { return of_point; });    \
        },                                                                                        \
        [](const EquilibriumRate& e) {                                                            \
          return ofPoints(e, [](const ShapePointRate& p) -> Eigen::Vector3d { return of_rate; }); \
        }                                                                                         \
  }
#define REACTION_FIELD(name, of_reaction)                                                              \
  {                                                                                                    \
    name,                                                                                              \
        [](const Equilibrium& e) {                                                                     \
          return ofReactions(e, [](const Reaction& r) -> Eigen::Vector3d { return of_reaction; });     \
        },                                                                                             \
        [](const EquilibriumRate& e) {                                                                 \
          return ofReactions(e, [](const ReactionRate& r) -> Eigen::Vector3d { return of_reaction; }); \
        }                                                                                              \
  }

const std::vector<Field>& fields() {
  static const std::vector<Field> all{
      SHAPE_FIELD("arc length", Eigen::Vector3d::Constant(p.arc_length),
                  Eigen::Vector3d::Constant(p.arc_length)),
      SHAPE_FIELD("position", p.pose.position, p.position),
      SHAPE_FIELD("tangent", p.tangent, p.tangent),
      SHAPE_FIELD("bend", p.second_derivative, p.second_derivative),
      SHAPE_FIELD("force", p.force, p.force),
      SHAPE_FIELD("moment", p.moment, p.moment),
      SHAPE_FIELD("strain", p.strain, p.strain),
      SHAPE_FIELD("curvature", p.curvature, p.curvature),
      REACTION_FIELD("clip force", r.force),
      REACTION_FIELD("clip moment", r.moment),
      REACTION_FIELD("clip arc length", Eigen::Vector3d::Constant(r.arc_length)),
      {"elastic energy", [](const Equilibrium& e) { return std::vector<double>{e.energy.elastic}; },
       [](const EquilibriumRate& e) { return std::vector<double>{e.elastic_energy}; }},
  };
  return all;
}

class Sensitivity : public testing::TestWithParam<NamedHarness> {
 protected:
  void SetUp() override {
    nominal_ = solver_.solve(harness_);
    ASSERT_TRUE(nominal_.converged()) << nominal_.message;
    for (const NamedRate& variable : variables_) rates_.push_back(variable.rate);
  }

  // An accuracy of a metre: the grid stays the one it starts with, so that differences see one discrete
  // system.
  static EquilibriumOptions onOneGrid() {
    EquilibriumOptions options;
    options.accuracy = options.force_accuracy = options.eigenvalue_accuracy = 1.0;
    return options;
  }

  Equilibrium solvedAt(std::size_t variable, double step) const {
    return EquilibriumSolver(solver_).update(changed(harness_, rates_[variable], step));
  }

  const Harness& harness_ = GetParam().harness;
  const std::vector<NamedRate> variables_ = ratesFor(harness_);
  std::vector<HarnessRate> rates_;
  EquilibriumSolver solver_{onOneGrid()};
  Equilibrium nominal_;
};

TEST_P(Sensitivity, IsTheSlopeOfResolvedEquilibria) {
  const std::vector<EquilibriumRate> derivatives = solver_.differentiate(rates_);
  ASSERT_EQ(derivatives.size(), variables_.size());

  for (std::size_t v = 0; v < variables_.size(); ++v) {
    SCOPED_TRACE(variables_[v].name);
    const auto at = [&](double step) { return solvedAt(v, step); };
    constexpr double kStep = 2.5e-4;
    const Equilibrium ahead = at(kStep), back = at(-kStep), far_ahead = at(2 * kStep),
                      far_back = at(-2 * kStep);
    ASSERT_TRUE(ahead.converged() && back.converged() && far_ahead.converged() && far_back.converged());
    for (const Field& field : fields()) {
      const std::vector<double> here = field.of(nominal_), a = field.of(ahead), b = field.of(back),
                                c = field.of(far_ahead), d = field.of(far_back);
      const std::vector<double> rate = field.rate(derivatives[v]);
      ASSERT_EQ(rate.size(), here.size());
      double size = 0.0, level = 0.0, worst = 0.0;
      for (std::size_t i = 0; i < rate.size(); ++i) {
        // of fourth order
        const double slope = (8.0 * (a[i] - b[i]) - (c[i] - d[i])) / (12.0 * kStep);
        size = std::max(size, std::abs(slope));
        level = std::max(level, std::abs(here[i]));
        worst = std::max(worst, std::abs(slope - rate[i]));
      }
      // 1e-6 of the derivative; and what rounding leaves of the values, stretch times a large EA, over the
      // step
      EXPECT_LE(worst, 1e-6 * size + 2e-7 * level) << field.name << " of size " << size;
    }
  }
}

TEST_P(Sensitivity, OfTheSmallestEigenvalueIsItsSlope) {
  const std::vector<double> derivatives = solver_.eigenvalueRates(rates_);
  for (std::size_t v = 0; v < variables_.size(); ++v) {
    const auto at = [&](double step) { return solvedAt(v, step).smallest_eigenvalue; };
    constexpr double kStep = 5e-4;
    const double slope = (8.0 * (at(kStep) - at(-kStep)) - (at(2 * kStep) - at(-2 * kStep))) / (12.0 * kStep);
    // eigenvalues are found to 1e-9 of themselves, here over the step
    EXPECT_NEAR(derivatives[v], slope, 2e-6 * std::abs(slope) + 2e-5 * nominal_.smallest_eigenvalue)
        << variables_[v].name << ", eigenvalue " << nominal_.smallest_eigenvalue;
  }
}

INSTANTIATE_TEST_SUITE_P(Sections, Sensitivity, testing::ValuesIn(harnessPerSection()), harnessName);
INSTANTIATE_TEST_SUITE_P(Clips, Sensitivity, testing::ValuesIn(harnessPerClip()), harnessName);
INSTANTIATE_TEST_SUITE_P(Joints, Sensitivity, testing::ValuesIn(harnessPerJoint()), harnessName);

TEST(EquilibriumSolver, HasNothingToDifferentiateBeforeItSolved) {
  EXPECT_THROW(EquilibriumSolver().differentiate({}), std::logic_error);
}

}  // namespace
}  // namespace cable_variation::test
