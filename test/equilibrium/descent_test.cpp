// The descent to a minimum: why it ends, and what of its options is refused.
#include <cable_variation/equilibrium/search/minimise.h>

#include <limits>
#include <stdexcept>
#include <string>

#include <gtest/gtest.h>

#include <equilibrium/cases.h>
#include <equilibrium/fixed_grid.h>

namespace cable_variation::test {
namespace {

Minimum descend(FixedGrid& rod, const MinimiseOptions& options) {
  rod.configuration =
      InitialShape(rod.harness, rod.topology).make(rod.system.grid(), {Routing{Routing::Bulge::natural, 0}});
  return minimise(rod.system, rod.configuration, options);
}

// A column without weight between clamps that are nearer than it is long: straight it is a saddle.
Harness pressedColumn() {
  const Cable column = uniformCable(0.5, roundSection(1e5, 4e4, 0.05, 0.05));
  return clamped(column, poseAt(0.49, 0.0, 0.0), Eigen::Vector3d::Zero());
}

TEST(Descent, endsInAMinimum) {
  FixedGrid rod(caseW(), 8);
  const Minimum found = descend(rod, {});
  EXPECT_EQ(found.end, DescentEnd::minimum);
  EXPECT_TRUE(found.stationary());
  EXPECT_TRUE(found.stable());
}

TEST(Descent, tellsThatItsStepsWereNotEnough) {
  FixedGrid rod(caseW(), 8);
  MinimiseOptions options;
  options.max_iterations = 3;
  const Minimum found = descend(rod, options);
  EXPECT_EQ(found.end, DescentEnd::most_iterations);
  EXPECT_EQ(found.iterations, 3);
  EXPECT_FALSE(found.stationary());
}

TEST(Descent, roughlyEndsWithLessSteps) {
  FixedGrid rod(caseW(), 8);
  const Minimum whole = descend(rod, {});
  const double energy = rod.system.energy().total();
  MinimiseOptions options;
  options.rough = true;
  const Minimum rough = descend(rod, options);
  EXPECT_EQ(rough.end, DescentEnd::near_minimum);
  EXPECT_TRUE(rough.stable());
  EXPECT_LT(rough.iterations, whole.iterations);
  EXPECT_NEAR(rod.system.energy().total(), energy, 1e-8 * energy);
}

TEST(Descent, settlesWhereItIsWhateverTheHessian) {
  FixedGrid rod(pressedColumn(), 8);
  MinimiseOptions options;
  options.settle = true;
  SpanConfiguration& span = rod.configuration.spans[0];
  for (std::size_t i = 0; i < span.positions.size(); ++i) {
    const double share = static_cast<double>(i) / static_cast<double>(span.positions.size() - 1);
    span.positions[i] = {0.49 * share, 0.0, 0.0};
    span.orientations[i].setIdentity();
  }
  const Minimum straight = minimise(rod.system, rod.configuration, options);
  EXPECT_EQ(straight.end, DescentEnd::saddle);
  EXPECT_TRUE(straight.stationary());
  EXPECT_FALSE(straight.stable());
  EXPECT_EQ(descend(rod, {}).end, DescentEnd::minimum) << "it buckles";
}

TEST(Descent, settlesNowhereFarAway) {
  FixedGrid rod(caseW(), 8);
  MinimiseOptions options;
  options.settle = true;
  EXPECT_EQ(descend(rod, options).end, DescentEnd::far_away);
}

TEST(Descent, tellsOfAForceThatIsNotANumber) {
  FixedGrid rod(caseW(), 8);
  rod.configuration =
      InitialShape(rod.harness, rod.topology).make(rod.system.grid(), {Routing{Routing::Bulge::natural, 0}});
  rod.configuration.spans[0].positions[4].x() = std::numeric_limits<double>::quiet_NaN();
  const Minimum found = minimise(rod.system, rod.configuration);
  EXPECT_FALSE(found.stationary());
  EXPECT_NE(found.end, DescentEnd::most_iterations) << "it went on with it";
}

TEST(DescentOptions, areOnlyTakenWithinTheirRanges) {
  EXPECT_NO_THROW(validate(DescentOptions()));
  const double none = std::numeric_limits<double>::quiet_NaN();
  for (const DescentNumber& number : descentNumbers()) {
    for (const double value : {number.lower - 1.0, number.upper + 1.0, none}) {
      if (value != value && std::string(number.name) == "longest_climb") continue;  // an integer
      EquilibriumOptions options;
      number.set(options.descent, value);
      try {
        const EquilibriumSolver solver(options);
        ADD_FAILURE() << number.name << " of " << value << " was taken";
      } catch (const std::invalid_argument& error) {
        EXPECT_NE(std::string(error.what()).find(number.name), std::string::npos) << error.what();
      }
    }
    for (const double bound : {number.lower, number.upper}) {
      const bool allowed = bound == number.lower ? number.lower_allowed : number.upper_allowed;
      DescentOptions options;
      number.set(options, bound);
      if (allowed) {
        EXPECT_NO_THROW(validate(options)) << number.name << " of " << bound;
      } else {
        EXPECT_THROW(validate(options), std::invalid_argument) << number.name << " of " << bound;
      }
    }
  }
}

TEST(DescentOptions, ofTheSolverAreLookedAtWheneverTheyAreSet) {
  EquilibriumSolver solver;
  EquilibriumOptions options;
  options.accuracy = 0.0;
  EXPECT_THROW(solver.setOptions(options), std::invalid_argument);
  options = {};
  options.max_iterations = 0;
  EXPECT_THROW(solver.setOptions(options), std::invalid_argument);
  options = {};
  options.eigenvalue_accuracy = -1.0;
  EXPECT_THROW(solver.setOptions(options), std::invalid_argument);
}

}  // namespace
}  // namespace cable_variation::test
