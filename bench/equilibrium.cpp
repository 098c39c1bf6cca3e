// Equilibria: cold, warm, and how the effort grows; beside them plain shooting
// as a yardstick. Cases H and W are those of test/data/reference; deviation_mm
// is the largest distance from the continuum solution there.

#include <benchmark/benchmark.h>

#include <random>
#include <stdexcept>
#include <vector>

#include <cable_variation/equilibrium/discretisation/grid.h>
#include <cable_variation/equilibrium/search/minimise.h>
#include <cable_variation/rod/kernel/element_kernel.h>
#include <equilibrium/cases.h>

#include "reference_case.h"
#include "shooting.h"

namespace cable_variation::bench {
namespace {

constexpr double kAccuracy = 1e-5;  // [m]: what the figures' 0.01 mm asks for

EquilibriumOptions options(bool multi_start) {
  EquilibriumOptions o;
  o.accuracy = kAccuracy;
  o.multi_start = multi_start;
  o.eigenvalue = false;  // stability is checked all the same; its figure is not part of a solve
  return o;
}

void requireConverged(const Equilibrium& result) {
  if (!result.converged()) throw std::runtime_error(std::string("not solved: ") + result.message);
}

void report(benchmark::State& state, const ReferenceCase& reference, const Equilibrium& result) {
  state.counters["deviation_mm"] = 1e3 * deviation(reference, result.shapes.front());
  state.counters["steps"] = result.iterations;
  state.SetLabel(element::kernel().instruction_set);
}

void solveCold(benchmark::State& state, char name, bool multi_start) {
  const ReferenceCase reference = referenceCase(name);
  EquilibriumSolver solver(options(multi_start));
  Equilibrium result;
  for (auto _ : state) {
    result = solver.solve(reference.harness);
    benchmark::DoNotOptimize(result);
  }
  requireConverged(result);
  report(state, reference, result);
}

// Clamp B moved from its nominal by up to 5 mm and 5°.
std::vector<Harness> nearby(const Harness& nominal) {
  std::mt19937 generator(1);
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  const auto vector = [&] {
    return Eigen::Vector3d(uniform(generator), uniform(generator), uniform(generator));
  };
  std::vector<Harness> harnesses;
  for (int i = 0; i < 64; ++i) {
    Harness harness = nominal;
    Pose& clamp = harness.clips.back().pose;
    clamp.position += 5e-3 * vector();
    clamp.orientation =
        clamp.orientation * so3::exp(5.0 * M_PI / 180.0 * uniform(generator) * vector().normalized());
    harnesses.push_back(harness);
  }
  return harnesses;
}

void solveWarm(benchmark::State& state, char name) {
  const ReferenceCase reference = referenceCase(name);
  const std::vector<Harness> harnesses = nearby(reference.harness);
  EquilibriumSolver solver(options(true));
  requireConverged(solver.solve(reference.harness));
  std::size_t i = 0;
  int steps = 0;
  // there and back: every solve is one move of clamp B by up to 5 mm and 5°
  for (auto _ : state) {
    const Harness& next = i % 2 == 0 ? harnesses[(i / 2) % harnesses.size()] : reference.harness;
    const Equilibrium result = solver.update(next);
    steps += result.iterations;
    ++i;
  }
  const Equilibrium result = solver.update(reference.harness);
  requireConverged(result);
  report(state, reference, result);
  state.counters["steps"] = benchmark::Counter(steps, benchmark::Counter::kAvgIterations);
}

ShootingSolver::Problem shootingProblem(const Harness& harness) {
  const Cable& cable = harness.cables.front();
  return {cable.sections.front().section, cable.length, harness.gravity, harness.clips.front().pose,
          harness.clips.back().pose};
}

void reportShooting(benchmark::State& state, const ReferenceCase& reference,
                    const ShootingSolver::Solution& solution) {
  double largest = 0.0;
  for (std::size_t i = 0; i < reference.positions.size(); ++i) {
    const double step =
        reference.arc_lengths[i] / reference.harness.cables.front().length * ShootingSolver::kSteps;
    const long column = std::lround(step);
    if (std::abs(step - static_cast<double>(column)) > 1e-6) continue;  // compare where both have a point
    largest = std::max(largest, (solution.centreline.col(column) - reference.positions[i]).norm());
  }
  state.counters["deviation_mm"] = 1e3 * largest;
  state.counters["steps"] = solution.iterations;
}

void shootCold(benchmark::State& state, char name) {
  const ReferenceCase reference = referenceCase(name);
  const ShootingSolver solver;
  ShootingSolver::Solution solution;
  for (auto _ : state) {
    solution = solver.solve(shootingProblem(reference.harness), Eigen::Matrix<double, 6, 1>::Zero());
    benchmark::DoNotOptimize(solution);
  }
  reportShooting(state, reference, solution);
}

void shootWarm(benchmark::State& state, char name) {
  const ReferenceCase reference = referenceCase(name);
  const std::vector<Harness> harnesses = nearby(reference.harness);
  const ShootingSolver solver;
  const auto nominal = solver.solve(shootingProblem(reference.harness), Eigen::Matrix<double, 6, 1>::Zero());
  std::size_t i = 0;
  for (auto _ : state) {
    const auto solution =
        solver.solve(shootingProblem(harnesses[i++ % harnesses.size()]), nominal.start_wrench);
    benchmark::DoNotOptimize(solution);
  }
  reportShooting(state, reference, nominal);
}

// One Newton step with residual on a grid of so many elements: what grows with the grid.
void newtonStep(benchmark::State& state) {
  const Harness harness = test::caseH();
  const Topology topology = makeTopology(harness);
  Grid grid(1);
  const auto elements = state.range(0);
  for (int i = 0; i <= elements; ++i)
    grid[0].push_back(static_cast<double>(i) / static_cast<double>(elements));
  RodSystem system(harness, topology, grid);
  const EquilibriumOptions o = options(false);
  const Equilibrium solved = EquilibriumSolver(o).solve(harness);
  Configuration configuration;
  configuration.stations = {{harness.clips[0].pose, 0.0}, {harness.clips[1].pose, harness.cables[0].length}};
  configuration.spans.resize(1);
  for (int i = 0; i < 3 * elements + 1; ++i) {
    const double s = harness.cables[0].length * i / (3.0 * static_cast<double>(elements));
    const Pose pose = solved.shapes[0].pose(s);
    configuration.spans[0].positions.push_back(pose.position);
    configuration.spans[0].orientations.push_back(pose.orientation);
  }
  const auto metric = (system.evaluate(configuration, RodSystem::Hessian::none), system.bendingMetric());
  NodalField step;
  for (auto _ : state) {
    system.evaluate(configuration, RodSystem::Hessian::exact);
    benchmark::DoNotOptimize(system.factorise(kNeutralShift, metric));
    system.solve(system.gradient(), step);
    benchmark::DoNotOptimize(system.residual());
  }
  state.SetComplexityN(elements);
}

// Cables side by side, each clamped at both ends with three clips of other kinds between.
Harness manyCables(int cables) {
  Harness harness;
  for (int c = 0; c < cables; ++c) {
    const auto index = static_cast<std::size_t>(c);
    const double y = 0.03 * c;
    harness.cables.push_back(test::uniformCable(0.5, test::strandOfCaseW(), "cable " + std::to_string(c)));
    harness.clips.push_back(test::clipOn(index, "A", 0.0, fixedClip(), test::poseAt(0.0, y, 0.0)));
    harness.clips.push_back(
        test::clipOn(index, "B", 0.12, rollingClip(), test::poseAt(0.11, y + 0.02, 0.01)));
    harness.clips.push_back(
        test::clipOn(index, "C", 0.25, slidingRollingClip(), test::poseAt(0.23, y, -0.01)));
    harness.clips.push_back(test::clipOn(index, "D", 0.38, pivotClip(), test::poseAt(0.35, y - 0.02, 0.0)));
    harness.clips.push_back(
        test::clipOn(index, "E", 0.5, fixedClip(), test::poseAt(0.46, y, 0.02, {0.0, -0.3, 0.2})));
  }
  return harness;
}

void solveFromNothing(benchmark::State& state, const Harness& harness, const EquilibriumOptions& with) {
  EquilibriumSolver solver(with);
  Equilibrium result;
  for (auto _ : state) {
    result = solver.solve(harness);
    benchmark::DoNotOptimize(result);
  }
  requireConverged(result);
  state.counters["steps"] = result.iterations;
}

void solveManyCables(benchmark::State& state) {
  const Harness harness = manyCables(static_cast<int>(state.range(0)));
  EquilibriumOptions o;
  o.eigenvalue = false;
  solveFromNothing(state, harness, o);
}

BENCHMARK_CAPTURE(solveCold, case_H, 'H', false)->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(solveCold, case_W, 'W', false)->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(solveCold, case_H_multi_start, 'H', true)->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(solveCold, case_W_multi_start, 'W', true)->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(shootCold, case_H, 'H')->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(shootCold, case_W, 'W')->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(solveWarm, case_H, 'H')->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(solveWarm, case_W, 'W')->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(shootWarm, case_H, 'H')->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(shootWarm, case_W, 'W')->Unit(benchmark::kMicrosecond);
BENCHMARK(newtonStep)->RangeMultiplier(8)->Range(8, 512)->Unit(benchmark::kMicrosecond)->Complexity();
BENCHMARK(solveManyCables)->Arg(1)->Arg(20)->Unit(benchmark::kMicrosecond);

}  // namespace
}  // namespace cable_variation::bench

BENCHMARK_MAIN();
