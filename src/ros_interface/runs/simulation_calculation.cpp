#include <ros_interface/runs/simulation_calculation.h>

#include <chrono>

#include <ros_interface/conversion/simulation_conversion.h>
#include <ros_interface/request/request_status.h>
#include <ros_interface/runs/simulation_files.h>

namespace cable_variation_ros {

using cable_variation::EquilibriumSolver;
using cable_variation::MeasureEvaluator;
using cable_variation::Scene;
using cable_variation::Simulation;
using cable_variation::SimulationObserver;
using cable_variation::Status;

namespace {

Status statusOf(const Simulation& simulation, const std::string& file_error) {
  Status status;
  if (!file_error.empty()) {
    status.code = Status::IO_ERROR;
    status.message = file_error;
  }
  if (simulation.ended_early) {
    status.code = Status::CANCELLED;
    std::string message = "cancelled after " + std::to_string(simulation.statistics.samples) + " of " +
                          std::to_string(simulation.statistics.wanted) + " samples";
    if (!file_error.empty()) message += "; " + file_error;
    status.message = message;
  }
  return status;
}

}  // namespace

SimulationResult calculateSimulation(const SimulationTask& task, const SolverContext::Snapshot& snapshot,
                                     const MeasureEvaluator& evaluator, const OutputDirectory& output,
                                     const SimulationObserver& observer) {
  const Scene& scene = snapshot.design.scene;
  const EquilibriumSolver solver = solverAt(snapshot, task.options, task.other_design);
  SimulationFiles files(output, task, scene);
  const Simulation simulation =
      simulateVariation(scene, evaluator, task.options, solver, files.receiver(), observer);

  SimulationResult result;
  result.origin = viewOrigin(snapshot, task.options.motions);
  result.response = toResponse(scene, task.options.values, simulation);
  for (const std::string& warning : warningsOfMoved(result.origin, task.options.motions)) {
    result.response.warnings.push_back(warning);
  }
  const auto start = std::chrono::steady_clock::now();
  files.finish(simulation, result.response);
  result.response.report_time =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  result.response.status = statusOf(simulation, files.error());
  if (result.response.solved + result.response.snapped > 1) {
    result.view = simulationView(scene, simulation, task.show, !task.options.motions.empty());
  }
  return result;
}

}  // namespace cable_variation_ros
