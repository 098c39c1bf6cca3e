#include <ros_interface/runs/simulation_run.h>

#include <utility>

#include <cable_variation/util/seconds_since.h>
#include <ros_interface/conversion/simulation_conversion.h>
#include <ros_interface/runs/simulation_files.h>

namespace cable_variation_ros {

using cable_variation::Clock;
using cable_variation::EquilibriumSolver;
using cable_variation::Scene;
using cable_variation::Simulation;
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

SimulationRun::SimulationRun(Request request, RunLimits limits, VariationPublisher& publisher)
    : request_(std::move(request)), limits_(std::move(limits)), publisher_(publisher) {}

void SimulationRun::prepare(const SolverContext& context) {
  task_ =
      toSimulationTask(request_, context.design(), context.moved(), limits_.threads, limits_.memory_limit);
  snapshot_ = context.snapshot();
  if (!task_.options.motions.empty()) snapshot_.design = withShiftsInScene(std::move(snapshot_.design));
  evaluator_.emplace(context.evaluator(snapshot_));
}

void SimulationRun::calculate(RunControl& control) {
  const Scene& scene = snapshot_.design.scene;
  const EquilibriumSolver solver = solverAt(snapshot_, task_.options, task_.other_design);
  SimulationFiles files(limits_.output, task_, scene, snapshot_.origin);
  const Simulation simulation =
      simulateVariation(scene, *evaluator_, task_.options, solver, files.receiver(), control.observer());

  origin_ = viewOrigin(snapshot_, task_.options.motions);
  response_ = toResponse(scene, task_.options.values, simulation);
  for (const std::string& warning : warningsOfMoved(origin_, task_.options.motions)) warn(warning);
  const Clock::time_point start = Clock::now();
  files.finish(simulation, response_);
  response_.report_time = cable_variation::secondsSince(start);
  response_.status = statusOf(simulation, files.error());
  if (response_.solved + response_.snapped > 1)
    view_ = simulationView(scene, simulation, task_.show, !task_.options.motions.empty());
}

bool SimulationRun::show(const SolverContext& context) {
  if (view_.markers.markers.empty()) return true;
  if (!origin_.fits(context)) return false;
  publisher_.show(view_.markers, view_.tubes, view_.legend,
                  [&publisher = publisher_, &context, origin = origin_] {
                    if (!origin.fits(context)) publisher.clear();
                  });
  return true;
}

}  // namespace cable_variation_ros
