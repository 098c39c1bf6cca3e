#include <cable_variation/analysis/simulation_calculation.h>

#include <utility>

#include <cable_variation/util/count_text.h>
#include <cable_variation/util/seconds_since.h>

namespace cable_variation {

namespace {

AnswerStatus statusOf(const Simulation& simulation, const std::string& file_error) {
  AnswerStatus status;
  if (!file_error.empty()) status = {StatusCode::io_error, file_error};
  if (simulation.ended_early) {
    std::string message = "cancelled after " + std::to_string(simulation.statistics.samples) + " of " +
                          countText(simulation.statistics.wanted, "sample");
    if (!file_error.empty()) message += "; " + file_error;
    status = {StatusCode::cancelled, message};
  }
  return status;
}

}  // namespace

SimulationCalculation calculateSimulation(const SimulationTask& task, const DesignSnapshot& snapshot,
                                          const MeasureEvaluator& evaluator, const OutputDirectory& output,
                                          RunControl& control, BlockExchange* exchange) {
  const Scene& scene = snapshot.design.scene;
  const EquilibriumSolver solver = solverAt(snapshot, task.options, task.other_design);
  SimulationFiles files(output, task, scene, snapshot.origin);
  SimulationCalculation found{simulateVariation(scene, evaluator, task.options, solver, files.receiver(),
                                                control.observer(), exchange),
                              {},
                              {}};
  const Clock::time_point start = Clock::now();
  found.paths = files.finish(found.simulation);
  found.report_time = secondsSince(start);
  found.status = statusOf(found.simulation, files.error());
  return found;
}

}  // namespace cable_variation
