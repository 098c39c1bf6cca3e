// Design variables found from measured shapes: from exact ones, from noisy ones, and what cannot be found.
#include <cable_variation/identification/identification.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <random>
#include <stdexcept>

#include <gtest/gtest.h>

#include <cable_variation/equilibrium/equilibrium.h>

#include "hanging_loop.h"

namespace cable_variation::test {
namespace {

using Eigen::Vector3d;

std::vector<std::size_t> variablesOf(const Scene& scene, const std::vector<std::string>& names) {
  std::vector<std::size_t> variables;
  for (const std::string& name : names) {
    for (std::size_t i = 0; i < scene.design_variables.size(); ++i) {
      if (scene.design_variables[i].name == name) variables.push_back(i);
    }
  }
  EXPECT_EQ(variables.size(), names.size());
  return variables;
}

/// Points on the wire of a design at uneven places, solved more finely than it is identified.
MeasuredShape shapeOf(const Scene& scene, const DesignValues& values, std::size_t count = 40) {
  EquilibriumOptions options;
  options.accuracy = 1e-8;
  EquilibriumSolver solver(options);
  const Equilibrium equilibrium = solver.solve(harnessAt(scene, values));
  EXPECT_TRUE(equilibrium.converged()) << equilibrium.message;
  MeasuredShape shape;
  shape.source = "made";
  const double length = scene.harness.cables[0].length;
  for (std::size_t i = 0; i < count; ++i) {
    const double share = (static_cast<double>(i) + 0.3 * std::sin(7.0 * static_cast<double>(i))) /
                         static_cast<double>(count - 1);
    shape.points.push_back(equilibrium.shapes[0].position(std::clamp(share, 0.0, 1.0) * length));
  }
  return shape;
}

TEST(identification, finds_what_exact_shapes_were_made_with) {
  std::mt19937 generator(5);
  const auto between = [&](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(generator);
  };
  Scene scene = hangingLoop({}, true);
  scene.accuracy = 1e-7;
  for (int i = 0; i < 8; ++i) {
    const DesignValues truth{{"EI", between(0.5e-4, 3e-4)},
                             {"curl", between(-4.0, 4.0)},
                             {"a_rz", between(-0.3, 0.3)},
                             {"b_rz", between(-0.3, 0.3)}};
    IdentificationTask task;
    task.variables = variablesOf(scene, {"EI", "curl", "a_rz", "b_rz"});
    task.shapes = {shapeOf(scene, truth)};
    const Identification found = identify(scene, task);
    EXPECT_TRUE(found.converged);
    for (std::size_t k = 0; k < task.variables.size(); ++k) {
      const std::string& name = scene.design_variables[task.variables[k]].name;
      const double size = name == "EI" ? truth.at(name) : 1.0;
      EXPECT_NEAR(found.values[k], truth.at(name), 1e-6 * size) << i << " " << name;
      EXPECT_TRUE(found.determined[k]) << i << " " << name;
    }
    EXPECT_LT(found.fits[0].largest, 2e-6) << i;
  }
}

// Two shapes with the second clamp in known places; a wire is as stiff as it hangs in both.
TEST(identification, takes_several_shapes_with_what_is_known_of_each) {
  Scene scene = hangingLoop({});
  scene.accuracy = 1e-7;
  IdentificationTask task;
  task.variables = variablesOf(scene, {"EI", "a_rz"});
  for (const double x : {-0.02, 0.025}) {
    task.shapes.push_back(shapeOf(scene, {{"EI", 0.8e-4}, {"a_rz", 0.1}, {"b_x", x}}));
    task.shapes.back().known = {{"b_x", x}};
  }
  const Identification found = identify(scene, task);
  EXPECT_NEAR(found.values[0], 0.8e-4, 1e-5 * 0.8e-4);
  EXPECT_NEAR(found.values[1], 0.1, 1e-5);
  ASSERT_EQ(found.fits.size(), 2U);

  // the same without what is known of the places cannot be met
  for (MeasuredShape& shape : task.shapes) shape.known.clear();
  const Identification wrong = identify(scene, task);
  EXPECT_GT(wrong.fits[0].rms, 1e-3);
}

// Under its weight alone a wire's shape knows EI over its weight, not both; and between clamps, which turn
// the wire by a given angle whatever it does, a uniform rest curvature does nothing at all.
TEST(identification, says_what_the_points_do_not_tell) {
  const Scene scene = hangingLoop({});
  IdentificationTask task;
  task.variables = variablesOf(scene, {"EI", "density", "curl"});
  task.shapes = {shapeOf(scene, {{"EI", 0.9e-4}})};
  const Identification found = identify(scene, task);
  EXPECT_FALSE(found.determined[2]);
  EXPECT_EQ(found.values[2], 1.0);
  EXPECT_TRUE(std::isinf(found.deviations[2]));
  EXPECT_NE(found.determined[0], found.determined[1]);
  EXPECT_NEAR(found.values[0] / found.values[1], 0.9e-4 / 0.0174, 1e-3 * 0.9e-4 / 0.0174);
  EXPECT_LT(found.fits[0].largest, 2e-5);
}

// Over many repeats the errors are as large as the standard deviations say.
// What is left of the distances is told, too, where no unknown is found.
TEST(identification, points_that_tell_nothing_have_their_noise) {
  const Scene scene = hangingLoop({});
  IdentificationTask task;
  task.variables = variablesOf(scene, {"curl"});  // uniform, between two clamps
  task.shapes = {shapeOf(scene, {{"EI", 0.9e-4}})};
  const Identification found = identify(scene, task);
  EXPECT_FALSE(found.determined[0]);
  EXPECT_GT(found.fits[0].rms, 1e-3);
  EXPECT_NEAR(found.noise, found.fits[0].rms / std::sqrt(2.0), 1e-12);
}

TEST(identification, standard_deviations_are_those_of_repeated_measurements) {
  constexpr double kNoise = 2e-3;  // [m]
  constexpr int kRepeats = 60;
  const Scene scene = hangingLoop({}, true);
  const DesignValues truth{{"EI", 1e-4}, {"curl", 2.0}, {"a_rz", 0.1}};
  const MeasuredShape exact = shapeOf(scene, truth);
  IdentificationTask task;
  task.variables = variablesOf(scene, {"EI", "curl", "a_rz"});
  std::mt19937 generator(8);
  std::normal_distribution<double> noise(0.0, kNoise);
  Eigen::Vector3d squares = Eigen::Vector3d::Zero();
  double noise_found = 0.0;
  for (int i = 0; i < kRepeats; ++i) {
    task.shapes = {exact};
    for (Vector3d& point : task.shapes[0].points)
      point += Vector3d(noise(generator), noise(generator), noise(generator));
    const Identification found = identify(scene, task);
    noise_found += found.noise / kRepeats;
    for (int k = 0; k < 3; ++k) {
      const std::string& name = scene.design_variables[task.variables[static_cast<std::size_t>(k)]].name;
      const double error = (found.values[static_cast<std::size_t>(k)] - truth.at(name)) / found.deviations[k];
      squares[k] += error * error / kRepeats;
    }
  }
  EXPECT_NEAR(noise_found, kNoise, 0.1 * kNoise);
  for (int k = 0; k < 3; ++k) {
    // 60 squares of a normal variable: 1 within 3.5 standard deviations of 0.18
    EXPECT_GT(squares[k], 0.36) << k;
    EXPECT_LT(squares[k], 1.64) << k;
  }
}

TEST(identification, tasks_that_are_none_are_refused) {
  const Scene scene = hangingLoop({});
  const MeasuredShape shape = shapeOf(scene, {});
  const auto refused = [&](const IdentificationTask& task, const std::string& part) {
    try {
      identify(scene, task);
      ADD_FAILURE() << part;
    } catch (const std::invalid_argument& error) {
      EXPECT_NE(std::string(error.what()).find(part), std::string::npos) << error.what();
    }
  };
  IdentificationTask task;
  refused(task, "none is given");
  task.shapes = {shape};
  refused(task, "unknowns: none");
  task.variables = {0, 0};
  refused(task, "'EI' is given twice");
  task.variables = {0};
  task.shapes[0].known = {{"EI", 1e-4}};
  refused(task, "'EI' is given, but it is to be found");
  task.shapes[0].known.clear();
  task.shapes[0].cable = 3;
  refused(task, "made: cable 3");
  task.shapes[0].cable = 0;
  task.shapes[0].points.resize(1);
  task.variables = {0, 1, 2};
  refused(task, "1 points for 3 unknowns; expected at least 2");
}

// Real wires that were photographed: what two repeats tell of them holds for the others. Measured data that
// may not be shipped.
TEST(identification, hanging_wires_that_had_no_part_in_it_are_met) {
  const char* folder = std::getenv("CABLE_VARIATION_DATA");
  const std::filesystem::path wires = std::filesystem::path(folder ? folder : "") / "hanging_wires";
  if (folder == nullptr || !std::filesystem::exists(wires))
    GTEST_SKIP() << "no files in $CABLE_VARIATION_DATA/hanging_wires";
  const Scene scene = hangingLoop({}, true);
  IdentificationTask task;
  task.variables = variablesOf(scene, {"EI", "curl", "a_rz", "b_rz"});
  std::vector<MeasuredShape> others;
  for (int i = 1; i <= 5; ++i) {
    MeasuredShape shape;
    shape.source = (wires / ("white_" + std::to_string(i) + ".csv")).string();
    shape.points = readMeasuredPoints(shape.source);
    (i <= 2 ? task.shapes : others).push_back(shape);
  }
  const Identification found = identify(scene, task);
  DesignValues values;
  for (std::size_t k = 0; k < task.variables.size(); ++k)
    values[scene.design_variables[task.variables[k]].name] = found.values[k];
  for (const ShapeFit& fit : compare(scene, values, others)) EXPECT_LE(fit.rms, 4e-3);
  EXPECT_NEAR(found.values[0], 1.0e-4, 0.2e-4);
}

}  // namespace
}  // namespace cable_variation::test
