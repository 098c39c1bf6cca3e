#include <ros_interface/runs/simulation_run.h>

#include <utility>

#include <cable_variation/analysis/simulation_calculation.h>
#include <ros_interface/conversion/simulation_conversion.h>
#include <ros_interface/request/request_status.h>
#include <ros_interface/runs/requests.h>

namespace cable_variation_ros {

using cable_variation::Scene;

SimulationRun::SimulationRun(Request request, RunLimits limits, VariationPublisher& publisher)
    : request_(std::move(request)), limits_(std::move(limits)), publisher_(publisher) {}

void SimulationRun::prepare(const SolverContext& context) {
  task_ = toSimulationTask(fromMessage(request_), context.design(), context.moved(), limits_.threads,
                           limits_.memory_limit);
  show_ = figureOf(request_.show);
  snapshot_ = snapshotFor(task_.options, context.snapshot());
  evaluator_.emplace(context.evaluator(snapshot_));
}

void SimulationRun::calculate(cable_variation::RunControl& control) {
  const Scene& scene = snapshot_.design.scene;
  const cable_variation::SimulationCalculation found =
      calculateSimulation(task_, snapshot_, *evaluator_, limits_.output, control);
  origin_ = viewOrigin(snapshot_, task_.options.motions);
  response_ = toResponse(scene, task_.options.values, found.simulation);
  for (const std::string& warning : warningsOfMoved(origin_, task_.options.motions)) warn(warning);
  response_.samples_file = found.paths.samples;
  response_.statistics_file = found.paths.statistics;
  response_.contributions_file = found.paths.contributions;
  response_.report_file = found.paths.report;
  response_.report_time = found.report_time;
  response_.status = toStatus(found.status);
  if (response_.solved + response_.snapped > 1)
    view_ = simulationView(scene, found.simulation, show_, !task_.options.motions.empty());
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
