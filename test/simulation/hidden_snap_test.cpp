// Flat strips pushed together, hinged at one end and clamped at the other, which turns: within some
// tolerances they flip over to the other side. The analysis and the simulation are held against steps so
// small that a flip is seen as one, and a steep change is not.
#include <cmath>
#include <cstdlib>
#include <optional>
#include <string>

#include <gtest/gtest.h>

#include <cable_variation/sensitivity/stability_analysis.h>
#include <cable_variation/simulation/simulation.h>
#include <cable_variation/util/counter_random.h>

#include <simulation/solved_design.h>

namespace cable_variation::test {
namespace {

constexpr double kDegree = M_PI / 180.0;

struct Strip {
  double length, gap;  // between its ends [m]
  double stiffness;    // EI about y [N m²]
  double weight;       // [kg/m]
  double pitch;        // of the clamp, nominal [rad]
  double tolerance;    // of the clamp's turn about y [rad]
  bool hinged;         // at the start; else clamped there too
};

Scene sceneOfStrip(const Strip& strip) {
  Section section;
  section.EA = 5000.0;
  section.GA_y = section.GA_z = 2000.0;
  section.EI_y = strip.stiffness;
  section.EI_z = 100.0 * strip.stiffness;
  section.GJ = 0.8 * strip.stiffness;
  section.mass_per_length = strip.weight;
  section.radius = 0.004;
  Harness harness =
      clamped(uniformCable(strip.length, section), poseAt(strip.gap, 0.0, 0.0, {0.0, strip.pitch, 0.0}),
              strip.weight > 0.0 ? Eigen::Vector3d(0.0, 0.0, -9.81) : Eigen::Vector3d::Zero());
  if (strip.hinged) harness.clips[0].constraint = hingeClip(Axis::y);
  Scene scene = sceneOf(harness);
  addVariable(scene, "r", ClipRotation{1, Axis::y}, -strip.tolerance, strip.tolerance);
  scene.design_variables[0].unit = "rad";
  Measure z = measure(Measure::Type::position, "z");
  z.unit = "m";
  z.arc_length = 0.5 * strip.length;
  z.direction = Eigen::Vector3d::UnitZ();
  scene.measures = {z};
  return scene;
}

Strip anyStrip(std::uint64_t row) {
  RandomRow random(CounterRandom(17, 0), row);
  const auto between = [&](double low, double high) { return low + (high - low) * random.uniform(); };
  Strip strip;
  strip.length = between(0.15, 0.6);
  strip.gap = strip.length * (1.0 - between(0.005, 0.08));
  strip.stiffness = between(0.01, 0.1);
  strip.weight = random.uniform() < 0.5 ? 0.0 : between(0.0, 0.1);
  strip.pitch = random.uniform() < 0.5 ? 0.0 : between(-10.0, 10.0) * kDegree;
  strip.tolerance = between(5.0, 60.0) * kDegree;
  strip.hinged = random.uniform() < 0.7;
  return strip;
}

Eigen::Matrix3Xd shapeOf(const Harness& harness, const Equilibrium& equilibrium) {
  Eigen::Matrix3Xd points(3, 9);
  for (int i = 0; i < 9; ++i)
    points.col(i) = equilibrium.shapes[0].position(0.1 * (i + 1) * harness.cables[0].length);
  return points;
}

double between(const Eigen::Matrix3Xd& a, const Eigen::Matrix3Xd& b) {
  return (a - b).colwise().norm().maxCoeff();
}

// The turn at which the strip flips on its way to `end`, by steps of a fifth of a degree: where it moves by
// two hundredths of its length in one of them, that step is gone through again in hundredths, and what still
// moves as far in one of those does not go back.
std::optional<double> flipOnTheWay(const Scene& scene, const SolvedDesign& design, double end) {
  EquilibriumSolver solver = design.solver;
  const double large = 0.02 * design.harness.cables[0].length;
  const auto go = [&](EquilibriumSolver& from, double turn) {
    const Harness harness = harnessAt(scene, {{"r", turn}});
    const Equilibrium found = from.update(harness);
    EXPECT_TRUE(found.converged()) << found.message << " at " << turn / kDegree;
    return found.converged() ? shapeOf(harness, found) : Eigen::Matrix3Xd::Zero(3, 9).eval();
  };
  const int steps = static_cast<int>(std::ceil(std::abs(end) / (0.2 * kDegree)));
  Eigen::Matrix3Xd here = shapeOf(design.harness, design.equilibrium);
  for (int i = 0; i < steps; ++i) {
    const double from = end * i / steps, to = end * (i + 1) / steps;
    EquilibriumSolver ahead = solver;
    const Eigen::Matrix3Xd there = go(ahead, to);
    if (between(here, there) > large) {
      EquilibriumSolver fine = solver;
      Eigen::Matrix3Xd last = here;
      for (int k = 0; k < 100; ++k) {
        const double before = from + (to - from) * k / 100, turn = from + (to - from) * (k + 1) / 100;
        const Eigen::Matrix3Xd next = go(fine, turn);
        if (between(last, next) > large) {
          EquilibriumSolver back = fine;
          if (between(go(back, before), last) > 0.5 * large) return turn;
        }
        last = next;
      }
    }
    solver = std::move(ahead);
    here = there;
  }
  return std::nullopt;
}

StabilityAnalysis analysed(const Scene& scene, const SolvedDesign& design) {
  return analyseStability(scene, design.evaluator(scene), {}, design.solver);
}

void expectSnapsAreTold(const Strip& strip, const std::string& name, int& flips, int& quiet) {
  const Scene scene = sceneOfStrip(strip);
  const SolvedDesign design(scene);
  ASSERT_TRUE(design.equilibrium.converged()) << name << design.equilibrium.message;
  const StabilityAnalysis analysis = analysed(scene, design);
  for (const double side : {-1.0, 1.0}) {
    const std::optional<double> expected = flipOnTheWay(scene, design, side * strip.tolerance);
    const SnapWithin* told = nullptr;
    for (const SnapWithin& snap : analysis.snaps) {
      if (side * snap.deviation > 0.0) told = &snap;
    }
    const std::string where =
        name + (side < 0.0 ? " down" : " up") + ", tolerance " + std::to_string(strip.tolerance / kDegree);
    ASSERT_EQ(told != nullptr, expected.has_value())
        << where << (expected ? ", flips at " + std::to_string(*expected / kDegree) : "")
        << (told ? ", told at " + std::to_string(told->deviation / kDegree) : "");
    if (!told) {
      ++quiet;
      continue;
    }
    ++flips;
    // one of 512 steps of the way, and one of the steps here
    EXPECT_NEAR(told->deviation, *expected, strip.tolerance / 256.0 + 0.2 * kDegree) << where;
    EXPECT_GT(told->jump, 0.01 * strip.length) << where;
    bool warned = false;
    for (const std::string& warning : analysis.warnings)
      warned = warned || warning.find("snap to another equilibrium") != std::string::npos;
    EXPECT_TRUE(warned) << where;
  }
}

TEST(HiddenSnap, IsToldWhateverTheSizeOfTheTolerance) {
  int flips = 0, quiet = 0;
  for (const double tolerance : {5.0, 15.0, 25.0, 30.0, 45.0, 60.0}) {
    expectSnapsAreTold({0.31, 0.3, 0.02, 0.1, 0.0, tolerance * kDegree, true}, "a strip of 31 cm", flips,
                       quiet);
    expectSnapsAreTold({0.31, 0.3, 0.02, 0.0, 0.0, tolerance * kDegree, true}, "without weight", flips,
                       quiet);
  }
  EXPECT_GT(flips, 3);
  EXPECT_GT(quiet, 3);
}

TEST(HiddenSnap, OfStripsAtRandomIsToldWhereThereIsOneAndNowhereElse) {
  int flips = 0, quiet = 0;
  const char* wanted = std::getenv("HIDDEN_SNAP_STRIPS");  // more of them
  const std::uint64_t strips = wanted ? std::strtoull(wanted, nullptr, 10) : 24;
  for (std::uint64_t row = 0; row < strips; ++row)
    expectSnapsAreTold(anyStrip(row), "strip " + std::to_string(row), flips, quiet);
  EXPECT_GT(flips, 5);
  EXPECT_GT(quiet, 5);
}

TEST(HiddenSnap, OfSamplesIsCounted) {
  for (const double tolerance : {30.0, 60.0}) {
    Scene scene = sceneOfStrip({0.31, 0.3, 0.02, 0.1, 0.0, tolerance * kDegree, true});
    scene.design_variables[0].distribution = "uniform";
    scene.design_variables[0].distribution_parameters.clear();
    const SolvedDesign design(scene);
    SimulationOptions options;
    options.variables = {0};
    options.samples = 200;
    const std::optional<double> down = flipOnTheWay(scene, design, -tolerance * kDegree);
    const std::optional<double> up = flipOnTheWay(scene, design, tolerance * kDegree);
    ASSERT_TRUE(down || up);
    std::size_t snapped = 0;
    simulateVariation(scene, design.evaluator(scene), options, design.solver,
                      [&](std::uint64_t, SampleOutcome outcome, const double* deviations, const double*) {
                        const double turn = deviations[0];
                        const auto beyond = [&](const std::optional<double>& flip, double side,
                                                double slack) {
                          return flip && side * turn > side * *flip + slack;
                        };
                        const double slack = 0.5 * kDegree;
                        const bool surely = beyond(down, -1.0, slack) || beyond(up, 1.0, slack);
                        const bool maybe = beyond(down, -1.0, -slack) || beyond(up, 1.0, -slack);
                        if (outcome == SampleOutcome::snapped) ++snapped;
                        if (surely) {
                          EXPECT_EQ(outcome, SampleOutcome::snapped) << turn / kDegree << " of " << tolerance;
                        } else if (!maybe) {
                          EXPECT_EQ(outcome, SampleOutcome::solved) << turn / kDegree << " of " << tolerance;
                        }
                      });
    EXPECT_GT(snapped, 0u);
  }
}

}  // namespace
}  // namespace cable_variation::test
