// Production simulated: rigid rods with closed forms, the shipped harness against the solver itself, a strip
// that snaps, threads, ends and motions.
#include <cable_variation/simulation/simulation.h>

#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include <cable_variation/scene_file/scene_reader.h>
#include <cable_variation/util/error.h>

#include <simulation/solved_design.h>

namespace cable_variation::test {
namespace {

constexpr double kDegree = M_PI / 180.0;
constexpr double kLength = 0.2;
constexpr double kSigma = 2.0 * kDegree;  // of the clip's turn; the tolerance is three of them

// A rod of kLength along x whose clip turns about y; where its tip is.
Scene turningRod() {
  Scene scene = freeRod(kLength, 2e-3);
  addVariable(scene, "turn", ClipRotation{0, Axis::y}, -3.0 * kSigma, 3.0 * kSigma);
  for (const Axis axis : {Axis::x, Axis::z}) {
    Measure tip = measure(Measure::Type::position, axis == Axis::x ? "tip_x" : "tip_z");
    tip.unit = "m";
    tip.arc_length = kLength;
    tip.direction = axis == Axis::x ? Eigen::Vector3d::UnitX() : Eigen::Vector3d::UnitZ();
    scene.measures.push_back(tip);
  }
  return scene;
}

// Lets the rod's clip ride on a part that moves for a second, recorded 200 times.
void putOnMovingPart(Scene& scene, double from, const std::function<Pose(double time)>& pose_at) {
  Component part;
  part.name = "part";
  scene.components.push_back(part);
  scene.clip_mounts[0].component = part.name;
  Motion motion;
  motion.name = "swing";
  motion.component = part.name;
  for (int i = 0; i <= 200; ++i) {
    const double time = from + 0.005 * i;
    motion.samples.push_back({time, pose_at(time)});
  }
  scene.motions.push_back(motion);
}

struct Sample {
  std::uint64_t index;
  SampleOutcome outcome;
  std::vector<double> deviations, values;

  bool operator==(const Sample& other) const {
    return index == other.index && outcome == other.outcome && deviations == other.deviations &&
           values == other.values;
  }
};

// All variables of the scene, in its order.
DesignValues valuesOf(const Scene& scene, const Sample& sample) {
  DesignValues values;
  for (std::size_t j = 0; j < sample.deviations.size(); ++j) {
    const DesignVariable& variable = scene.design_variables[j];
    values[variable.name] = variable.nominal + sample.deviations[j];
  }
  return values;
}

struct Produced {
  Simulation simulation;
  std::vector<Sample> samples;
};

Produced simulate(const Scene& scene, const SimulationOptions& options,
                  const ProgressObserver& observer = {}) {
  const SolvedDesign design(scene);
  Produced run;
  const std::size_t variables = options.variables.size();
  const std::size_t measures = options.measures.empty() ? scene.measures.size() : options.measures.size();
  const auto receive = [&](std::uint64_t index, SampleOutcome outcome, const double* deviations,
                           const double* values) {
    Sample sample{index, outcome, {deviations, deviations + variables}, {}};
    if (values != nullptr) sample.values.assign(values, values + measures);
    run.samples.push_back(std::move(sample));
  };
  run.simulation =
      simulateVariation(scene, design.evaluator(scene), options, design.solver, receive, observer);
  return run;
}

SimulationOptions optionsFor(const Scene& scene, std::uint64_t samples) {
  SimulationOptions options;
  options.variables = allOf(scene.design_variables.size());
  options.samples = samples;
  return options;
}

Scene shippedHarness() {
  const std::string root = CABLE_VARIATION_SOURCE_DIR;
  return readScene(root + "/config/harness.yaml", [&](const std::string&) { return root; });
}

TEST(simulation, of_a_rigid_rod_is_as_its_closed_form) {
  const Scene scene = turningRod();
  const Produced run = simulate(scene, optionsFor(scene, 4000));
  ASSERT_EQ(run.samples.size(), 4000u);
  for (std::size_t i = 0; i < run.samples.size(); ++i) {
    const Sample& sample = run.samples[i];
    ASSERT_EQ(sample.index, i);
    ASSERT_EQ(sample.outcome, SampleOutcome::solved);
    const double turn = sample.deviations[0];
    EXPECT_NEAR(sample.values[0], kLength * std::cos(turn), 1e-7);
    EXPECT_NEAR(sample.values[1], -kLength * std::sin(turn), 1e-7);
  }
  // a normal angle: E cos = exp(-σ²/2), Var sin = (1 - exp(-2σ²))/2
  const double s2 = kSigma * kSigma;
  const double sigma_z = kLength * std::sqrt(0.5 * (1.0 - std::exp(-2.0 * s2)));
  const auto& of = run.simulation.statistics.statistics;
  const double mean_error = 4.0 / std::sqrt(4000.0);  // four standard errors
  EXPECT_NEAR(of[1].mean, 0.0, mean_error * sigma_z);
  EXPECT_NEAR(of[1].sigma, sigma_z, mean_error * sigma_z / std::sqrt(2.0));
  const double sigma_x = kLength * s2 / std::sqrt(2.0);  // of 1 - θ²/2, a chi-squared variable
  EXPECT_NEAR(of[0].mean, kLength * std::exp(-0.5 * s2), mean_error * sigma_x);
  // what the linear model knows sharpens the one and not the other
  ASSERT_TRUE(of[1].controlled);
  EXPECT_NEAR(of[1].controlled->sigma, sigma_z, 1e-3 * sigma_z);
  EXPECT_GT(of[1].controlled->sigma_gain, 100.0);
  EXPECT_FALSE(of[0].controlled && of[0].controlled->mean_gain > 2.0);
}

TEST(simulation, tells_how_the_cable_varies_along_itself) {
  const Scene scene = turningRod();
  SimulationOptions options = optionsFor(scene, 4000);
  options.sections = 11;
  options.kept_shapes = 3;
  const Produced run = simulate(scene, options);
  ASSERT_EQ(run.simulation.cables.size(), 1u);
  const CableVariation& cable = run.simulation.cables[0];
  ASSERT_EQ(cable.sections.size(), 11u);
  double sum = 0.0, least = 0.0, most = 0.0;
  for (const Sample& sample : run.samples) {
    sum += sample.values[1] * sample.values[1];
    least = std::min(least, sample.values[1]);
    most = std::max(most, sample.values[1]);
  }
  for (std::size_t i = 0; i < 11; ++i) {
    const double share = static_cast<double>(i) / 10.0;
    EXPECT_NEAR(cable.arc_length[i], share * kLength, 1e-12);
    // every section is at its share of the tip's way
    EXPECT_NEAR(cable.sections[i].axes.sigma[0], share * std::sqrt(sum / 4000.0), 2e-3 * kLength * kSigma);
    EXPECT_NEAR(cable.sections[i].range.maxCoeff(), share * (most - least), 1e-6);
    if (i > 0) {
      EXPECT_GT(std::abs(cable.sections[i].axes.directions.col(0).z()), 0.999);
    }
  }
  ASSERT_EQ(run.simulation.shapes.size(), 3u);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(run.simulation.shapes[i].index, i);
    EXPECT_NEAR(run.simulation.shapes[i].cables[0](2, 10), run.samples[i].values[1], 1e-9);
  }
}

TEST(simulation, solves_every_sample_as_the_solver_itself) {
  Scene scene = shippedHarness();
  scene.measures.pop_back();  // the eigenvalue has a test of its own
  SimulationOptions options = optionsFor(scene, 64);
  const Produced run = simulate(scene, options);
  const SolvedDesign design(scene);
  const MeasureEvaluator evaluator = design.evaluator(scene);
  for (const Sample& sample : run.samples) {
    if (sample.outcome != SampleOutcome::solved) continue;
    EquilibriumSolver solver = design.solver;
    const Solved solved = solveAt(scene, valuesOf(scene, sample), solver);
    ASSERT_TRUE(solved.equilibrium.converged());
    const auto expected = evaluator.evaluate(solved.view(), allOf(scene.measures.size()));
    for (std::size_t i = 0; i < expected.size(); ++i) {
      // both are within the accuracy [m]; forces and moments to some parts in a thousand
      const double scale = std::abs(expected[i].value);
      const bool length =
          scene.measures[i].unit == "m" && scene.measures[i].type != Measure::Type::bend_radius;
      EXPECT_NEAR(sample.values[i], expected[i].value, length ? 2.0 * scene.accuracy : 0.01 * scale)
          << "sample " << sample.index << ", " << scene.measures[i].name;
    }
  }
  EXPECT_GT(run.simulation.statistics.count(SampleOutcome::solved), 55u);
  EXPECT_LE(run.simulation.discretisation_error, scene.accuracy);
}

TEST(simulation, knows_the_smallest_eigenvalue_of_every_sample) {
  Scene scene = shippedHarness();
  scene.measures = {scene.measures.back()};
  ASSERT_EQ(scene.measures[0].type, Measure::Type::eigenvalue);
  const Produced run = simulate(scene, optionsFor(scene, 24));
  const SolvedDesign design(scene);
  for (const Sample& sample : run.samples) {
    if (sample.outcome != SampleOutcome::solved) continue;
    EquilibriumSolver solver = design.solver;
    const Equilibrium found = solver.update(harnessAt(scene, valuesOf(scene, sample)));
    EXPECT_NEAR(sample.values[0], found.smallest_eigenvalue, 0.01 * found.smallest_eigenvalue)
        << "sample " << sample.index;
  }
}

TEST(simulation, gives_the_same_bits_whatever_the_threads) {
  const Scene scene = shippedHarness();
  SimulationOptions options = optionsFor(scene, 600);
  options.measures = {0, 2, 4};
  std::optional<Produced> first;
  for (const std::size_t threads : {1, 2, 5}) {
    options.threads = threads;
    Produced run = simulate(scene, options, [](const Progress&) { return true; });
    if (!first) {
      first = std::move(run);
      continue;
    }
    EXPECT_TRUE(run.samples == first->samples);
    for (std::size_t i = 0; i < 3; ++i) {
      const MeasureStatistics &a = first->simulation.statistics.statistics[i],
                              &b = run.simulation.statistics.statistics[i];
      EXPECT_EQ(a.mean, b.mean);
      EXPECT_EQ(a.sigma, b.sigma);
      EXPECT_EQ(a.kurtosis, b.kurtosis);
      EXPECT_EQ(a.percentiles.front().value, b.percentiles.front().value);
    }
    for (std::size_t cable = 0; cable < run.simulation.cables.size(); ++cable) {
      for (std::size_t k = 0; k < run.simulation.cables[cable].sections.size(); ++k) {
        EXPECT_EQ(run.simulation.cables[cable].sections[k].covariance,
                  first->simulation.cables[cable].sections[k].covariance);
      }
    }
    EXPECT_EQ(run.simulation.statistics.contributions.first_order,
              first->simulation.statistics.contributions.first_order);
  }
}

TEST(simulation, keeps_what_was_done_when_it_is_ended) {
  const Scene scene = shippedHarness();
  SimulationOptions options = optionsFor(scene, 1000000);
  options.measures = {0, 4};
  std::vector<Progress> told;
  const Produced run = simulate(scene, options, [&](const Progress& progress) {
    told.push_back(progress);
    return told.size() < 3 || progress.done < 500;
  });
  const std::uint64_t done = run.simulation.statistics.samples;
  EXPECT_TRUE(run.simulation.ended_early);
  EXPECT_GE(done, 500u);
  EXPECT_LT(done, 50000u);
  EXPECT_EQ(run.simulation.statistics.wanted, 1000000u);
  EXPECT_EQ(run.samples.size(), done);
  ASSERT_GE(told.size(), 3u);
  EXPECT_EQ(told.back().wanted, 1000000u);
  EXPECT_EQ(told.back().stage, "samples");
  EXPECT_EQ(told.back().share, static_cast<double>(told.back().done) / 1000000.0);
  ASSERT_EQ(told.back().figures.size(), 2u);
  EXPECT_EQ(told.back().figures[0].measure, scene.measures[0].name);
  EXPECT_GT(told.back().figures[0].sigma, 0.0);
  // a simulation of just so many tells the same
  options.samples = done;
  const Produced whole = simulate(scene, options);
  EXPECT_FALSE(whole.simulation.ended_early);
  EXPECT_TRUE(run.samples == whole.samples);
  EXPECT_EQ(run.simulation.statistics.statistics[0].sigma, whole.simulation.statistics.statistics[0].sigma);
}

TEST(simulation, ends_when_sigma_is_known_well_enough) {
  const Scene scene = turningRod();
  SimulationOptions options = optionsFor(scene, 100000);
  options.measures = {0};  // the linear model says nothing of it
  options.sigma_error = 0.05;
  const Produced run = simulate(scene, options);
  const MeasureStatistics& of = run.simulation.statistics.statistics[0];
  const std::uint64_t done = run.simulation.statistics.samples;
  EXPECT_LT(done, 100000u);
  EXPECT_LE(0.5 * (of.sigma_interval.high - of.sigma_interval.low), 0.055 * of.sigma);
  // of a chi-squared variable of kurtosis 15 the variance's relative variance is 14/n: 1.96 √(14/n)/2 = 0.05
  // at 5400; the kurtosis itself is an estimate, and the count at most doubles from one look to the next
  EXPECT_GT(done, 2700u);
  EXPECT_LT(done, 16200u);
  options.samples = 1200;  // too few
  const Produced few = simulate(scene, options);
  EXPECT_EQ(few.simulation.statistics.samples, 1200u);
  ASSERT_FALSE(few.simulation.warnings.empty());
  EXPECT_NE(few.simulation.warnings.back().find("1200"), std::string::npos);
}

TEST(simulation, counts_and_lists_what_snaps) {
  Scene scene = bowedStrip();
  scene.design_variables[0].distribution = "uniform";
  scene.design_variables[0].distribution_parameters.clear();
  SimulationOptions options = optionsFor(scene, 96);
  options.sampler = SamplerType::latin_hypercube;
  const Produced run = simulate(scene, options);
  const SimulationStatistics& statistics = run.simulation.statistics;
  std::uint64_t snapped = 0;
  double first_snapped = -1.0, last_solved = 1.0;  // turns, from the side that snaps
  for (const Sample& sample : run.samples) {
    const double turn = sample.deviations[0];
    if (sample.outcome == SampleOutcome::snapped) {
      ++snapped;
      first_snapped = std::max(first_snapped, turn);
    } else {
      ASSERT_EQ(sample.outcome, SampleOutcome::solved);
      last_solved = std::min(last_solved, turn);
    }
  }
  EXPECT_GT(snapped, 10u);
  EXPECT_LT(snapped, 86u);
  EXPECT_EQ(statistics.count(SampleOutcome::snapped), snapped);
  EXPECT_EQ(statistics.listed.size(), snapped);
  EXPECT_LT(first_snapped, last_solved);  // on one side of a turn, and on no other
  // that turn, found by following the strip in small steps
  SolvedDesign design(scene);
  double before = 0.0, turn = 0.0;
  for (double height = 1.0; height > 0.0; turn -= 0.1 * kDegree) {
    before = turn;
    const Equilibrium found = design.solver.update(harnessAt(scene, {{"turn", turn}}));
    height = found.shapes[0].position(0.5 * scene.harness.cables[0].length).y();
  }
  EXPECT_LT(first_snapped, before + 0.5 * kDegree);
  EXPECT_GT(last_solved, turn - 0.5 * kDegree);
}

// The rod's clip rides on a part that swings; at every time the tip is where the part and the clip's turn
// together take it.
TEST(simulation, over_a_motion_takes_the_worst_of_every_sample) {
  Scene scene = turningRod();
  const double swing = 10.0 * kDegree;
  putOnMovingPart(scene, 0.0, [&](double time) -> Pose {
    const double angle = swing * std::sin(2.0 * M_PI * time);
    return {Eigen::Vector3d::Zero(), so3::exp(angle * Eigen::Vector3d::UnitY())};
  });
  scene.measures[1].upper = 0.1;  // the tip is worst where it is highest
  SimulationOptions options = optionsFor(scene, 256);
  options.measures = {1};
  options.motions = {0};
  const Produced at_rest = simulate(scene, options);
  options.from = options.to = 0.125;
  const Produced at_time = simulate(scene, options);
  options.from = 0.0;
  options.to = 1.0;
  const Produced worst = simulate(scene, options);
  const double there = swing * std::sin(2.0 * M_PI * 0.125);
  for (std::size_t i = 0; i < 256; ++i) {
    const double turn = at_rest.samples[i].deviations[0];
    EXPECT_NEAR(at_rest.samples[i].values[0], -kLength * std::sin(turn), 1e-6);
    EXPECT_NEAR(at_time.samples[i].values[0], -kLength * std::sin(there + turn), 1e-6);
    EXPECT_NEAR(worst.samples[i].values[0], -kLength * std::sin(turn - swing), 1e-5);
  }
  ASSERT_EQ(worst.simulation.missed.size(), 1u);
  EXPECT_LT(worst.simulation.missed[0], 1e-4);
  std::uint64_t votes = 0;
  for (const SimulatedTime& time : worst.simulation.times) {
    votes += time.worst;
    if (time.worst > 0) {
      EXPECT_NEAR(time.time, 0.75, 0.011);
    }
  }
  EXPECT_EQ(votes, 256u);
}

// A bend radius that is infinite at all times, one that has a say, and what has neither derivative nor limit
// do not change the times that the others are looked at.
TEST(simulation, over_a_motion_an_infinite_measure_has_no_say) {
  Scene scene = turningRod();
  putOnMovingPart(scene, 1.0, [](double time) -> Pose {
    const double angle = 10.0 * kDegree * std::sin(4.0 * M_PI * time);
    return {0.05 * std::sin(2.0 * M_PI * time) * Eigen::Vector3d::UnitX(),
            so3::exp(angle * Eigen::Vector3d::UnitY())};
  });
  scene.measures[0].lower = 0.0;
  scene.measures[0].upper = 0.2;
  Measure bend = measure(Measure::Type::bend_radius, "bend");
  bend.unit = "m";
  bend.lower = 0.06;
  scene.measures.push_back(bend);
  SimulationOptions options = optionsFor(scene, 64);
  options.motions = {0};
  options.from = 1.0;
  options.to = 2.0;
  options.measures = {0, 1};
  const Simulation without = simulate(scene, options).simulation;
  EXPECT_GT(without.times.size(), 2u);
  for (const std::vector<std::size_t>& measures :
       std::vector<std::vector<std::size_t>>{{0, 1, 2}, {2, 0, 1}, {0, 2, 1}}) {
    options.measures = measures;
    const Simulation with = simulate(scene, options).simulation;
    ASSERT_EQ(with.times.size(), without.times.size());
    for (std::size_t i = 0; i < with.times.size(); ++i) EXPECT_EQ(with.times[i].time, without.times[i].time);
    ASSERT_EQ(with.missed.size(), 3u);
    for (std::size_t i = 0; i < 3; ++i) EXPECT_TRUE(std::isfinite(with.missed[i]));
    bool warned = false;
    for (const std::string& warning : with.warnings)
      warned = warned || warning.find("bend has no finite value of the design in") == 0;
    EXPECT_TRUE(warned);
  }
  // by itself it leaves the times evenly spread over the phases of the motion
  options.measures = {2};
  const Simulation alone = simulate(scene, options).simulation;
  EXPECT_GT(alone.times.size(), 2u);
  for (const SimulatedTime& time : alone.times) {
    EXPECT_GE(time.time, 1.0);
    EXPECT_LE(time.time, 2.0);
  }
  EXPECT_EQ(alone.statistics.statistics[0].infinite, 64u);
}

TEST(simulation, can_be_ended_before_its_first_sample) {
  Scene scene = shippedHarness();
  Motion motion;
  motion.name = "drift";
  motion.component = "engine";
  for (int i = 0; i <= 2000; ++i) {
    const double x = 0.01 * std::sin(0.5 * i);
    motion.samples.push_back({0.01 * i,
                              {scene.components[1].pose.position + x * Eigen::Vector3d::UnitX(),
                               scene.components[1].pose.orientation}});
  }
  ASSERT_EQ(scene.components[1].name, "engine");
  scene.motions = {motion};
  SimulationOptions options = optionsFor(scene, 1000);
  options.motions = {0};
  options.to = 20.0;
  const Produced run = simulate(scene, options, [](const Progress&) { return false; });
  EXPECT_TRUE(run.simulation.ended_early);
  EXPECT_EQ(run.simulation.statistics.samples, 0u);
  EXPECT_TRUE(run.samples.empty());
  EXPECT_TRUE(std::isnan(run.simulation.statistics.statistics[0].mean));
}

TEST(simulation, without_measures_tells_of_the_cables) {
  Scene scene = turningRod();
  scene.measures.clear();
  const Produced run = simulate(scene, optionsFor(scene, 500));
  EXPECT_EQ(run.simulation.statistics.samples, 500u);
  EXPECT_TRUE(run.simulation.statistics.statistics.empty());
  EXPECT_NEAR(run.simulation.cables[0].sections.back().axes.sigma[0], kLength * kSigma,
              0.2 * kLength * kSigma);  // six standard errors of 500 samples
}

struct Refusal {
  const char* says;
  void (*spoil)(Scene&, SimulationOptions&);
};

TEST(simulation, refuses_what_it_cannot_do_and_says_what) {
  const std::array<Refusal, 14> refusals = {{
      {"no design variables", [](Scene&, SimulationOptions& o) { o.variables.clear(); }},
      {"design variable", [](Scene&, SimulationOptions& o) { o.variables = {7}; }},
      {"twice",
       [](Scene&, SimulationOptions& o) {
         o.variables = {0, 0};
       }},
      {"measure number 9", [](Scene&, SimulationOptions& o) { o.measures = {9}; }},
      {"samples: 0", [](Scene&, SimulationOptions& o) { o.samples = 0; }},
      {"samples: 1000000001", [](Scene&, SimulationOptions& o) { o.samples = kMostSamples + 1; }},
      {"confidence: 1", [](Scene&, SimulationOptions& o) { o.confidence = 1.0; }},
      {"sigma_error: -0.1", [](Scene&, SimulationOptions& o) { o.sigma_error = -0.1; }},
      {"latin_hypercube",
       [](Scene&, SimulationOptions& o) {
         o.sigma_error = 0.1;
         o.sampler = SamplerType::latin_hypercube;
       }},
      {"sections: 1", [](Scene&, SimulationOptions& o) { o.sections = 1; }},
      {"most_times", [](Scene&, SimulationOptions& o) { o.most_times = 0; }},
      {"from 2 s to 1 s",
       [](Scene&, SimulationOptions& o) {
         o.from = 2.0;
         o.to = 1.0;
       }},
      {"motion number 3", [](Scene&, SimulationOptions& o) { o.motions = {3}; }},
      {"'length' at its lower limit",
       [](Scene& scene, SimulationOptions& o) {
         addVariable(scene, "length", CableProperty{0, CableProperty::Property::length}, -0.3, 0.3);
         scene.design_variables.back().nominal = kLength;
         o.variables.push_back(1);
       }},
  }};
  for (const Refusal& refusal : refusals) {
    Scene scene = turningRod();
    SimulationOptions options = optionsFor(scene, 100);
    refusal.spoil(scene, options);
    try {
      simulate(scene, options);
      ADD_FAILURE() << "taken: " << refusal.says;
    } catch (const std::invalid_argument& error) {
      EXPECT_NE(std::string(error.what()).find(refusal.says), std::string::npos) << error.what();
    }
  }
}

TEST(simulation, of_a_design_that_no_equilibrium_can_exist_for_says_so) {
  Scene scene = bowedStrip();  // between clips 0.26 m apart
  addVariable(scene, "length", CableProperty{0, CableProperty::Property::length}, -0.001, 0.001);
  scene.design_variables.back().nominal = scene.harness.cables[0].length;
  SimulationOptions options = optionsFor(scene, 100);
  options.values["length"] = 0.2;
  EXPECT_THROW(simulate(scene, options), Impossible);
}

// A tolerance that can be built, but a distribution without limits: what cannot be is counted, not refused.
TEST(simulation, counts_what_cannot_be_built) {
  Scene scene = turningRod();
  addVariable(scene, "length", CableProperty{0, CableProperty::Property::length}, -0.19, 0.19);
  scene.design_variables.back().nominal = kLength;
  scene.design_variables.back().distribution_parameters["sigma"] = 1.0;
  const Produced run = simulate(scene, optionsFor(scene, 400));
  std::uint64_t negative = 0;
  for (const Sample& sample : run.samples) {
    const bool possible = kLength + sample.deviations[1] > 0.0;
    negative += possible ? 0 : 1;
    if (!possible) {
      EXPECT_EQ(sample.outcome, SampleOutcome::impossible);
    }
  }
  EXPECT_GT(negative, 20u);  // a seventh is beyond one standard deviation
  EXPECT_GE(run.simulation.statistics.count(SampleOutcome::impossible), negative);
  EXPECT_EQ(run.simulation.statistics.statistics[0].missing,
            run.simulation.statistics.count(SampleOutcome::impossible) +
                run.simulation.statistics.count(SampleOutcome::not_converged));
}

}  // namespace
}  // namespace cable_variation::test
