// Production simulated: samples per second with all that is told of them, on one thread and on two, real
// time; memory over ten million samples; how often confidence intervals hold the true value.

#include <benchmark/benchmark.h>

#include <sys/resource.h>

#include <cmath>
#include <numeric>
#include <optional>
#include <stdexcept>

#include <cable_variation/simulation/simulation.h>
#include <envelope/envelope_scenes.h>

#include "shipped_case.h"

namespace cable_variation::bench {
namespace {

struct Case {
  Scene scene;
  Harness harness;
  ComponentPoses components;
  Equilibrium equilibrium;
  EquilibriumSolver solver;
  std::optional<MeasureEvaluator> evaluator;
  SimulationOptions options;

  Case(Scene of, std::size_t variables) : scene(std::move(of)) {
    EquilibriumOptions accuracy;
    accuracy.accuracy = scene.accuracy;
    solver = EquilibriumSolver(accuracy);
    harness = harnessAt(scene, {});
    components = componentPosesAt(scene, {});
    equilibrium = solver.solve(harness);
    if (!equilibrium.converged()) throw std::runtime_error("not solved: " + equilibrium.message);
    evaluator.emplace(scene, SolvedScene{harness, equilibrium, components});
    options.variables.resize(variables);
    std::iota(options.variables.begin(), options.variables.end(), std::size_t{0});
  }
  Case(const Case&) = delete;

  Simulation simulate(const SimulationOptions& with) const {
    return simulateVariation(scene, *evaluator, with, solver);
  }
};

double peakMegabytes() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_maxrss) / 1024.0;
}

std::size_t triangleCount(const Component& component) {
  std::size_t count = 0;
  for (const Visual& visual : component.visuals) count += visual.mesh ? visual.mesh->triangles.size() : 0;
  return count;
}

void run(benchmark::State& state, const Case& of, SimulationOptions options) {
  options.threads = static_cast<std::size_t>(state.range(0));
  Simulation simulation;
  for (auto _ : state) simulation = of.simulate(options);
  const auto samples = static_cast<double>(simulation.statistics.samples);
  state.counters["samples_per_s"] =
      benchmark::Counter(samples, benchmark::Counter::kIsIterationInvariantRate);
  state.counters["solved_again"] = static_cast<double>(simulation.solved_again) / samples;
  state.counters["snapped"] = static_cast<double>(simulation.statistics.count(SampleOutcome::snapped));
  state.counters["failed"] = static_cast<double>(simulation.statistics.count(SampleOutcome::not_converged) +
                                                 simulation.statistics.count(SampleOutcome::impossible));
}

// The connectors' five turns; six measures, one of them the distance to the engine bay.
void harnessOfFive(benchmark::State& state) {
  static const Case of(shippedCase("harness"), 5);
  SimulationOptions options = of.options;
  for (const char* name : {"D_CAR", "bend", "middle_height", "start_force", "breakout_moment", "strain"}) {
    for (std::size_t i = 0; i < of.scene.measures.size(); ++i) {
      if (of.scene.measures[i].name == name) options.measures.push_back(i);
    }
  }
  run(state, of, options);
  state.counters["triangles"] =
      static_cast<double>(triangleCount(of.scene.components[*of.scene.measures[0].component]));
}
BENCHMARK(harnessOfFive)->Arg(1)->Arg(2)->Unit(benchmark::kSecond)->UseRealTime();

// All ten variables and all thirteen measures.
void harnessWithAll(benchmark::State& state) {
  static const Case of(shippedCase("harness"), 10);
  SimulationOptions options = of.options;
  options.samples = 4000;
  run(state, of, options);
}
BENCHMARK(harnessWithAll)->Arg(1)->Arg(2)->Unit(benchmark::kSecond)->UseRealTime();

// The hose's worst over the engine's run.
void hoseOverTheRun(benchmark::State& state) {
  static const Case of(shippedCase("hose"), 3);
  SimulationOptions options = of.options;
  options.motions = {0};
  options.to = of.scene.motions[0].duration();
  options.samples = 1000;
  run(state, of, options);
}
BENCHMARK(hoseOverTheRun)->Arg(2)->Unit(benchmark::kSecond)->UseRealTime()->Iterations(1);

// A rod held at one end that turns by a normal angle; the position of its tip.
Scene turningRod() {
  Scene scene = test::freeRod(0.2, 2e-3);
  test::addVariable(scene, "turn", ClipRotation{0, Axis::y}, -6.0 * kDegree, 6.0 * kDegree);
  Measure tip = test::measure(Measure::Type::position, "tip");
  tip.arc_length = 0.2;
  tip.direction = Eigen::Vector3d::UnitZ();
  scene.measures = {tip};
  return scene;
}

void memory(benchmark::State& state) {
  static const Case of(turningRod(), 1);
  SimulationOptions options = of.options;
  options.samples = static_cast<std::uint64_t>(state.range(0));
  for (auto _ : state) benchmark::DoNotOptimize(of.simulate(options));
  state.counters["peak_MB"] = peakMegabytes();
}
BENCHMARK(memory)->Arg(100000)->Arg(10000000)->Unit(benchmark::kSecond)->UseRealTime()->Iterations(1);

// Of so many seeds, in which the 95 % intervals of mean and σ hold those of a sine of a normal angle:
// E = 0, Var = L²(1 - exp(-2σ²))/2.
void coverage(benchmark::State& state) {
  static const Case of(turningRod(), 1);
  constexpr int kSeeds = 1000;
  const double sigma_angle = 2.0 * kDegree;
  const double sigma = 0.2 * std::sqrt(0.5 * (1.0 - std::exp(-2.0 * sigma_angle * sigma_angle)));
  SimulationOptions options = of.options;
  options.samples = 500;
  options.sections = 2;
  int mean_held = 0, sigma_held = 0;
  for (auto _ : state) {
    for (options.seed = 1; options.seed <= kSeeds; ++options.seed) {
      const MeasureStatistics statistics = of.simulate(options).statistics.statistics[0];
      mean_held += statistics.mean_interval.low <= 0.0 && statistics.mean_interval.high >= 0.0 ? 1 : 0;
      sigma_held += statistics.sigma_interval.low <= sigma && statistics.sigma_interval.high >= sigma ? 1 : 0;
    }
  }
  state.counters["mean_percent"] = 100.0 * mean_held / kSeeds;
  state.counters["sigma_percent"] = 100.0 * sigma_held / kSeeds;
}
BENCHMARK(coverage)->Unit(benchmark::kSecond)->UseRealTime()->Iterations(1);

}  // namespace
}  // namespace cable_variation::bench

BENCHMARK_MAIN();
