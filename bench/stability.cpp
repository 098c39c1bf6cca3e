// Stability analysis of the harness case: 12 measures by 30 variables, beside one warm equilibrium of the
// same harness and the equilibria that differences would need.

#include <benchmark/benchmark.h>

#include <numeric>
#include <stdexcept>
#include <string>
#include <vector>

#include <cable_variation/sensitivity/stability_analysis.h>

#include "shipped_case.h"

namespace cable_variation::bench {
namespace {

// The shipped case with 30 variables, and all measures that a single factorisation differentiates: 12.
Scene harnessCase() {
  Scene scene = harnessOfThirtyVariables();
  std::vector<Measure> measures;
  for (const Measure& measure : scene.measures) {
    if (measure.type != Measure::Type::eigenvalue) measures.push_back(measure);
  }
  scene.measures = measures;
  const std::size_t variables = scene.design_variables.size();
  if (scene.measures.size() != 12 || variables != 30) {
    throw std::runtime_error(std::to_string(scene.measures.size()) + " measures by " +
                             std::to_string(variables) + " variables, not 12 by 30");
  }
  return scene;
}

struct Solved {
  Scene scene = harnessCase();
  ComponentPoses components = componentPosesAt(scene, {});
  EquilibriumSolver solver;
  Equilibrium equilibrium;
  std::vector<std::size_t> measures, variables;

  Solved() : solver(options()) {
    equilibrium = solver.solve(scene.harness);
    if (!equilibrium.converged()) throw std::runtime_error("not solved: " + equilibrium.message);
    measures.resize(scene.measures.size());
    std::iota(measures.begin(), measures.end(), std::size_t{0});
    variables.resize(scene.design_variables.size());
    std::iota(variables.begin(), variables.end(), std::size_t{0});
  }

  EquilibriumOptions options() const {
    EquilibriumOptions o;
    o.accuracy = scene.accuracy;
    o.eigenvalue = false;
    return o;
  }
  SolvedScene at() const { return {scene.harness, equilibrium, components}; }
};

const Solved& solved() {
  static const Solved once;
  return once;
}

const MeasureEvaluator& evaluator() {
  static const MeasureEvaluator once(solved().scene, solved().at());
  return once;
}

// One equilibrium after WH_Start turned by its tolerance, and back.
void warmEquilibrium(benchmark::State& state) {
  EquilibriumSolver solver = solved().solver;
  const Harness turned = harnessAt(solved().scene, {{"wh_start_ry", 5.0 * kDegree}});
  bool back = false;
  for (auto _ : state) {
    if (!solver.update(back ? solved().scene.harness : turned).converged())
      throw std::runtime_error("not solved");
    back = !back;
  }
}
BENCHMARK(warmEquilibrium)->Unit(benchmark::kMicrosecond);

void jacobian(benchmark::State& state) {
  const Solved& at = solved();
  EquilibriumSolver solver = at.solver;
  const std::vector<MeasureValue> values = evaluator().evaluate(at.at(), at.measures);
  Eigen::MatrixXd derivatives;
  for (auto _ : state) {
    const std::vector<DesignRate> design = designRates(at.scene, {}, {}, at.variables);
    std::vector<HarnessRate> rates;
    for (const DesignRate& rate : design) rates.push_back(rate.harness);
    derivatives = evaluator().jacobian(at.at(), at.measures, values, design, solver.differentiate(rates));
  }
  if (!derivatives.allFinite()) throw std::runtime_error("a derivative is not finite");
}
BENCHMARK(jacobian)->Unit(benchmark::kMicrosecond);

void derivativesOfTheShape(benchmark::State& state) {
  const Solved& at = solved();
  EquilibriumSolver solver = at.solver;
  std::vector<HarnessRate> rates;
  for (const DesignRate& rate : designRates(at.scene, {}, {}, at.variables)) rates.push_back(rate.harness);
  for (auto _ : state) benchmark::DoNotOptimize(solver.differentiate(rates));
}
BENCHMARK(derivativesOfTheShape)->Unit(benchmark::kMicrosecond);

void measuresOfOneShape(benchmark::State& state) {
  const Solved& at = solved();
  const MeasureEvaluator& prepared = evaluator();
  for (auto _ : state) benchmark::DoNotOptimize(prepared.evaluate(at.at(), at.measures));
}
BENCHMARK(measuresOfOneShape)->Unit(benchmark::kMicrosecond);

// All there is: derivatives, spread, 60 re-solved equilibria.
void wholeAnalysis(benchmark::State& state) {
  const MeasureEvaluator& prepared = evaluator();
  for (auto _ : state) {
    benchmark::DoNotOptimize(analyseStability(solved().scene, prepared, {}, solved().solver));
  }
}
BENCHMARK(wholeAnalysis)->Unit(benchmark::kMicrosecond);

void preparingTheParts(benchmark::State& state) {
  for (auto _ : state) benchmark::DoNotOptimize(MeasureEvaluator(solved().scene, solved().at()));
}
BENCHMARK(preparingTheParts)->Unit(benchmark::kMicrosecond);

}  // namespace
}  // namespace cable_variation::bench

BENCHMARK_MAIN();
