// Many equilibria: one by one as EquilibriumSolver::update() finds them, and eight at once. Items per second
// are equilibria of one core; deviation_mm is the largest distance of the nominal shape on the batch's grid
// from the continuum solution in test/data/reference.

#include <benchmark/benchmark.h>

#include <random>
#include <stdexcept>
#include <string>
#include <vector>

#include <cable_variation/equilibrium/batch_solver.h>
#include <cable_variation/rod/kernel/element_kernel.h>
#include <cable_variation/scene_file/scene_reader.h>
#include <equilibrium/cases.h>

#include "reference_case.h"

namespace cable_variation::bench {
namespace {

constexpr std::size_t kHarnesses = 256;

// A nominal harness, and others of its tolerances.
struct Production {
  Harness nominal;
  std::vector<Harness> harnesses;
};

// Clamp B off by up to 5 mm and 5°.
Production movedClamp(char name) {
  Production production{name == 'H' ? test::caseH() : test::caseW(), {}};
  std::mt19937 generator(1);
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  const auto vector = [&] {
    return Eigen::Vector3d(uniform(generator), uniform(generator), uniform(generator));
  };
  for (std::size_t i = 0; i < kHarnesses; ++i) {
    Harness harness = production.nominal;
    Pose& clamp = harness.clips.back().pose;
    clamp.position += 5e-3 * vector();
    clamp.orientation =
        clamp.orientation * so3::exp(5.0 * M_PI / 180.0 * uniform(generator) * vector().normalized());
    production.harnesses.push_back(harness);
  }
  return production;
}

// The shipped harness case over the tolerances of all its variables.
Production harnessCase() {
  const std::string root = CABLE_VARIATION_SOURCE_DIR;
  const Scene scene = readScene(root + "/config/harness.yaml", [&](const std::string&) { return root; });
  Production production{harnessAt(scene, {}), {}};
  std::mt19937 generator(1);
  for (std::size_t i = 0; i < kHarnesses; ++i) {
    DesignValues values;
    for (const DesignVariable& variable : scene.design_variables) {
      std::uniform_real_distribution<double> within(variable.lower, variable.upper);
      values[variable.name] = variable.nominal + within(generator);
    }
    production.harnesses.push_back(harnessAt(scene, values));
  }
  return production;
}

Production productionOf(char name) { return name == 'S' ? harnessCase() : movedClamp(name); }

EquilibriumSolver solved(const Harness& harness) {
  EquilibriumOptions options;  // 0.1 mm
  options.eigenvalue = false;
  EquilibriumSolver solver(options);
  const Equilibrium result = solver.solve(harness);
  if (!result.converged()) throw std::runtime_error("not solved: " + result.message);
  return solver;
}

void oneByOne(benchmark::State& state, char name) {
  const Production production = productionOf(name);
  EquilibriumSolver solver = solved(production.nominal);
  std::size_t i = 0;
  int steps = 0;
  // from each to the next, as far apart as two of a batch
  for (auto _ : state) {
    const Equilibrium result = solver.update(production.harnesses[i++ % kHarnesses]);
    steps += result.iterations;
    benchmark::DoNotOptimize(result);
  }
  state.SetItemsProcessed(state.iterations());
  state.counters["steps"] = benchmark::Counter(steps, benchmark::Counter::kAvgIterations);
  state.SetLabel(element::kernel().instruction_set);
}

void atOnce(benchmark::State& state, char name, bool describe) {
  const Production production = productionOf(name);
  BatchSolver batch(solved(production.nominal));
  std::size_t i = 0;
  double steps = 0.0, failed = 0.0;
  for (auto _ : state) {
    batch.solve(&production.harnesses[i], BatchSolver::kBatch);
    for (std::size_t k = 0; k < BatchSolver::kBatch; ++k) {
      steps += batch.outcome(k).iterations;
      failed += batch.outcome(k).converged() ? 0.0 : 1.0;
      if (describe) benchmark::DoNotOptimize(batch.describe(k));
    }
    i = (i + BatchSolver::kBatch) % kHarnesses;
  }
  const auto solved_count = static_cast<double>(state.iterations()) * BatchSolver::kBatch;
  state.SetItemsProcessed(static_cast<std::int64_t>(solved_count));
  state.counters["us_each"] =
      benchmark::Counter(1e-6 * solved_count, benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
  state.counters["steps"] = steps / solved_count;
  state.counters["failed"] = failed / solved_count;
  if (name != 'S') {
    batch.solve(&production.nominal, 1);
    state.counters["deviation_mm"] = 1e3 * deviation(referenceCase(name), batch.describe(0).shapes.front());
  }
  state.SetLabel(element::kernel().instruction_set);
}

BENCHMARK_CAPTURE(oneByOne, case_H, 'H')->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(atOnce, case_H, 'H', false)->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(atOnce, case_H_described, 'H', true)->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(oneByOne, case_W, 'W')->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(atOnce, case_W, 'W', false)->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(atOnce, case_W_described, 'W', true)->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(oneByOne, harness_case, 'S')->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(atOnce, harness_case, 'S', false)->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(atOnce, harness_case_described, 'S', true)->Unit(benchmark::kMicrosecond);

}  // namespace
}  // namespace cable_variation::bench

BENCHMARK_MAIN();
