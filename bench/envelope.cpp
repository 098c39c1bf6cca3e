// Envelopes of the shipped cases: time, and what the figures of containment and tightness are by many more
// fresh shapes than are usual. Real time, on all cores.

#include <benchmark/benchmark.h>

#include <sys/resource.h>

#include <numeric>
#include <stdexcept>

#include <cable_variation/envelope/clearance/envelope_clearance.h>
#include <cable_variation/envelope/envelope_generator.h>

#include "shipped_case.h"
#include "envelope/hand_held.h"

namespace cable_variation::bench {
namespace {

struct Case {
  Scene scene;
  EquilibriumSolver solver;
  EnvelopeOptions options;

  Case(Scene of, std::size_t variables) : scene(std::move(of)) {
    EquilibriumOptions accuracy;
    accuracy.accuracy = scene.accuracy;
    solver = EquilibriumSolver(accuracy);
    const Equilibrium nominal = solver.solve(scene.harness);
    if (!nominal.converged()) throw std::runtime_error("not solved: " + nominal.message);
    options.variables.resize(variables);
    std::iota(options.variables.begin(), options.variables.end(), std::size_t{0});
  }
};

const Case& harnessOfFive() {
  static const Case once(shippedCase("harness"), 5);
  return once;
}

// All of its variables at their full tolerances: the harness snaps over where many are at their worst
// together.
const Case& harnessOfTen() {
  static const Case once(shippedCase("harness"), 10);
  return once;
}

// What so much of production takes up of it.
const Case& productionOfTen() {
  static const Case once = [] {
    Case made(shippedCase("harness"), 10);
    made.options.probability = 0.9973;
    return made;
  }();
  return once;
}

// At a fifth of their tolerances: 30 full ones, all at their worst together, take the harness past snaps.
const Case& harnessOfThirty() {
  static const Case once = [] {
    Scene scene = harnessOfThirtyVariables();
    for (DesignVariable& variable : scene.design_variables) {
      variable.lower *= 0.2;
      variable.upper *= 0.2;
    }
    return Case(std::move(scene), 30);
  }();
  return once;
}

// The hose on the engine's run, by the three translations of its cooler end.
const Case& hose() {
  static const Case once = [] {
    Case made(shippedCase("hose"), 3);
    made.options.motions = {0};
    made.options.margin = 2e-4;
    return made;
  }();
  return once;
}

// A hose long enough to be held in a hand that goes 0.25 m to all sides, over half a minute at 100 Hz.
const Case& hoseInTheHand() {
  static const Case once = [] {
    constexpr double kLength = 0.8;
    Scene scene = shippedCase("hose");
    scene.harness.cables[0].length = kLength;
    scene.harness.clips[1].arc_length = kLength;
    for (DesignVariable& variable : scene.design_variables) {
      if (variable.name == "hose_length") variable.nominal = kLength;
    }
    scene.motions[0].samples = test::handHeldRecording(scene.components[1].pose);
    Case made(std::move(scene), 3);
    made.options.motions = {0};
    made.options.frames = clearanceFrames(made.scene, made.options);
    return made;
  }();
  return once;
}

// With `shapes` for containment and `tightness` for the volume of their union.
void generate(benchmark::State& state, const Case& of, std::size_t shapes, std::size_t tightness) {
  EnvelopeOptions options = of.options;
  options.verification = shapes;
  options.tightness = tightness;
  Envelope envelope;
  for (auto _ : state) envelope = generateEnvelope(of.scene, options, of.solver);
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  const auto count = [](std::size_t number) { return static_cast<double>(number); };
  state.counters["solves"] = count(envelope.solves);
  state.counters["phases"] = count(envelope.phases.size());
  state.counters["outside"] = count(envelope.containment.outside);
  state.counters["bound_ppm"] = 1e6 * envelope.containment.outside_bound;
  state.counters["excess_mm"] = 1e3 * envelope.containment.largest_excess;
  state.counters["branches"] = count(envelope.branches);
  state.counters["protrusion_mm"] = 1e3 * envelope.containment.largest_protrusion;
  state.counters["motion_excess_mm"] = 1e3 * envelope.motion_excess;
  state.counters["inflation_mm"] = 1e3 * envelope.inflation;
  state.counters["largest_inflation_mm"] = 1e3 * envelope.largest_inflation;
  if (tightness > 0) {
    state.counters["tightness"] = envelope.tightness.ratio();
    state.counters["cm3"] = 1e6 * envelope.tightness.envelope_volume;
    state.counters["shapes_cm3"] = 1e6 * envelope.tightness.shapes_volume;
  }
  state.counters["failed"] = count(envelope.containment.failed + envelope.failures);
  state.counters["peak_MB"] = static_cast<double>(usage.ru_maxrss) / 1024.0;
}

void fiveVariables(benchmark::State& state) { generate(state, harnessOfFive(), 2000, 0); }
BENCHMARK(fiveVariables)->Unit(benchmark::kSecond)->UseRealTime();

void fiveVariablesBy100000Shapes(benchmark::State& state) { generate(state, harnessOfFive(), 100000, 10000); }
BENCHMARK(fiveVariablesBy100000Shapes)->Unit(benchmark::kSecond)->UseRealTime()->Iterations(1);

void tenVariables(benchmark::State& state) { generate(state, harnessOfTen(), 2000, 0); }
BENCHMARK(tenVariables)->Unit(benchmark::kSecond)->UseRealTime()->Iterations(1);

void tenVariablesBy100000Shapes(benchmark::State& state) { generate(state, harnessOfTen(), 100000, 10000); }
BENCHMARK(tenVariablesBy100000Shapes)->Unit(benchmark::kSecond)->UseRealTime()->Iterations(1);

void production(benchmark::State& state) { generate(state, productionOfTen(), 0, 0); }
BENCHMARK(production)->Unit(benchmark::kSecond)->UseRealTime()->Iterations(1);

void productionBy100000Samples(benchmark::State& state) { generate(state, productionOfTen(), 100000, 10000); }
BENCHMARK(productionBy100000Samples)->Unit(benchmark::kSecond)->UseRealTime()->Iterations(1);

void thirtyVariables(benchmark::State& state) { generate(state, harnessOfThirty(), 2000, 0); }
BENCHMARK(thirtyVariables)->Unit(benchmark::kSecond)->UseRealTime()->Iterations(1);

void thirtyVariablesBy100000Shapes(benchmark::State& state) { generate(state, harnessOfThirty(), 100000, 0); }
BENCHMARK(thirtyVariablesBy100000Shapes)->Unit(benchmark::kSecond)->UseRealTime()->Iterations(1);

void hoseOverTheRun(benchmark::State& state) { generate(state, hose(), 2000, 0); }
BENCHMARK(hoseOverTheRun)->Unit(benchmark::kSecond)->UseRealTime()->Iterations(1);

void hoseOverTheRunBy10000Shapes(benchmark::State& state) { generate(state, hose(), 10000, 3000); }
BENCHMARK(hoseOverTheRunBy10000Shapes)->Unit(benchmark::kSecond)->UseRealTime()->Iterations(1);

void hoseInTheHandForHalfAMinute(benchmark::State& state) { generate(state, hoseInTheHand(), 2000, 0); }
BENCHMARK(hoseInTheHandForHalfAMinute)->Unit(benchmark::kSecond)->UseRealTime()->Iterations(1);

}  // namespace
}  // namespace cable_variation::bench

BENCHMARK_MAIN();
