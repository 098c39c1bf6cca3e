// Cables that touch parts, beside the same without the parts.

#include <benchmark/benchmark.h>

#include <random>
#include <stdexcept>
#include <utility>
#include <vector>

#include <cable_variation/equilibrium/equilibrium.h>
#include <cable_variation/scene/scene.h>
#include <contact/contact_cases.h>
#include <equilibrium/cases.h>

#include "shipped_case.h"

namespace cable_variation::bench {
namespace {

EquilibriumOptions options() {
  EquilibriumOptions o;
  o.accuracy = 1e-5;
  o.eigenvalue = false;  // stability is checked all the same; its figure is not part of a solve
  return o;
}

void requireConverged(const Equilibrium& result) {
  if (!result.converged()) throw std::runtime_error(std::string("not solved: ") + result.message);
}

void solveCold(benchmark::State& state, const Harness& harness) {
  EquilibriumSolver solver(options());
  Equilibrium result;
  for (auto _ : state) {
    result = solver.solve(harness);
    benchmark::DoNotOptimize(result);
  }
  requireConverged(result);
  state.counters["steps"] = result.iterations;
}

// From one harness to others and back.
void solveWarm(benchmark::State& state, const Harness& harness, const std::vector<Harness>& others) {
  EquilibriumSolver solver(options());
  requireConverged(solver.solve(harness));
  std::size_t i = 0;
  int steps = 0;
  for (auto _ : state) {
    const Equilibrium result = solver.update(i % 2 == 0 ? others[(i / 2) % others.size()] : harness);
    requireConverged(result);
    steps += result.iterations;
    ++i;
  }
  state.counters["steps"] = benchmark::Counter(steps, benchmark::Counter::kAvgIterations);
}

// A cable of 500 mm that is held at both ends and hangs down to a table of 20,000 triangles, where its end is
// moved by up to 5 mm; and as it would hang without the table.
Harness overTable(bool touching) {
  Harness harness =
      test::clamped(test::uniformCable(0.5, test::roundSection(1e4, 4e3, 8e-3, 1e-2, 0.1, 0.004)),
                    test::poseAt(0.4, 0.05, 0.03));
  harness.clips[0].pose = test::poseAt(0.0, 0.0, 0.05);
  if (touching) {
    harness.contacts = {test::contactWith(
        "table", test::rectangle(Eigen::Vector2d(-0.5, -0.5), Eigen::Vector2d(1.0, 0.5), 100, 100))};
  }
  return harness;
}

void hangCold(benchmark::State& state, bool touching) { solveCold(state, overTable(touching)); }

void hangWarm(benchmark::State& state, bool touching) {
  const Harness harness = overTable(touching);
  std::mt19937 generator(1);
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  std::vector<Harness> harnesses;
  for (int i = 0; i < 20; ++i) {
    Harness moved = harness;
    for (int axis = 0; axis < 3; ++axis) moved.clips[1].pose.position[axis] += 5e-3 * uniform(generator);
    harnesses.push_back(std::move(moved));
  }
  solveWarm(state, harness, harnesses);
}

// The shipped harness with its first connector turned by its tolerances, so that the bundle lies on a stay's
// tab; or goes through it. Warm: turned by up to 1° less.
Harness harnessTurned(bool touching, double ry, double rz) {
  static const Scene with = shippedCase("harness_contact"), without = shippedCase("harness");
  const Scene& scene = touching ? with : without;
  return harnessAt(scene, {{"wh_start_ry", ry * kDegree}, {"wh_start_rz", rz * kDegree}});
}

void harnessCold(benchmark::State& state, bool touching) {
  solveCold(state, harnessTurned(touching, 5.0, 5.0));
}

void harnessWarm(benchmark::State& state, bool touching) {
  std::vector<Harness> harnesses;
  for (int i = 1; i <= 10; ++i) harnesses.push_back(harnessTurned(touching, 5.0 - 0.1 * i, 5.0 - 0.05 * i));
  solveWarm(state, harnessTurned(touching, 5.0, 5.0), harnesses);
}

// The shipped bundle that lies along 200 mm of a rail and in two clips; warm, as its length varies by 0.4 mm.
Harness onRail(double longer) {
  static const Scene scene = shippedCase("rail");
  return harnessAt(scene, {{"length", scene.design_variables[0].nominal + longer}});
}

void railCold(benchmark::State& state) { solveCold(state, onRail(0.0)); }

void railWarm(benchmark::State& state) {
  std::vector<Harness> harnesses;
  for (int i = 1; i <= 8; ++i) harnesses.push_back(onRail((i % 2 == 0 ? 1e-4 : -1e-4) * ((i + 1) / 2)));
  solveWarm(state, onRail(0.0), harnesses);
}

BENCHMARK_CAPTURE(hangCold, free, false)->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(hangCold, on_a_table, true)->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(hangWarm, free, false)->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(hangWarm, on_a_table, true)->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(harnessCold, through_the_tab, false)->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(harnessCold, on_the_tab, true)->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(harnessWarm, through_the_tab, false)->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(harnessWarm, on_the_tab, true)->Unit(benchmark::kMicrosecond);
BENCHMARK(railCold)->Unit(benchmark::kMicrosecond);
BENCHMARK(railWarm)->Unit(benchmark::kMicrosecond);

}  // namespace
}  // namespace cable_variation::bench

BENCHMARK_MAIN();
