#include <ros_interface/services/solve_equilibrium_service.h>

#include <ros/node_handle.h>

#include <cable_variation/analysis/design_trial.h>
#include <cable_variation/analysis/design_values.h>
#include <cable_variation/measures/open_parts.h>
#include <cable_variation/util/chosen_indices.h>
#include <ros_interface/context/solver_context.h>
#include <ros_interface/conversion/measure_conversion.h>
#include <ros_interface/conversion/message_conversion.h>
#include <ros_interface/node/names.h>
#include <ros_interface/request/name_registry.h>
#include <ros_interface/request/request_status.h>
#include <ros_interface/runs/report_file.h>
#include <ros_interface/runs/requests.h>

namespace cable_variation_ros {

using cable_variation::ComponentPoses;
using cable_variation::Scene;

SolveEquilibriumService::SolveEquilibriumService(ros::NodeHandle& node, const SolverContext& context,
                                                 const cable_variation::OutputDirectory& output,
                                                 NameRegistry& names)
    : context_(context),
      output_(output),
      names_(names),
      server_(node.advertiseService(kSolveEquilibriumService, &SolveEquilibriumService::handle, this)) {}

bool SolveEquilibriumService::handle(Request& request, Response& response) {
  response = answered<Response>([&] { return solve(request); });
  return true;
}

SolveEquilibriumService::Response SolveEquilibriumService::solve(const Request& request) {
  if (!request.report.empty()) cable_variation::OutputDirectory::checkName(request.report);
  const NameRegistry::Hold hold(names_, "report", request.report, kSolveEquilibriumService);
  const Scene& scene = context_.design().scene;
  const cable_variation::DesignValues values = toDesignValues(scene, request.variables, request.values);
  const ComponentPoses moved = request.motion.empty()
                                   ? context_.moved()
                                   : placesDuring(context_.design(), request.motion, request.time);
  const SolverContext::Trial trial = context_.solve(values, moved, request.follow);
  Response response = toResponse(trial.equilibrium, trial.harness);
  const std::vector<std::size_t> all = cable_variation::allIndices(scene.measures.size());
  const std::vector<cable_variation::MeasureValue> measured = context_.measure(trial, all);
  for (const std::size_t i : all)
    response.measures.push_back(toResult(scene.measures[i], measured[i], scene));
  for (std::string& warning : openPartWarnings(scene, context_.parts(), componentsMeasured(scene, all)))
    response.warnings.push_back(std::move(warning));
  if (!request.report.empty()) writeReport(request, trial, values, measured, response);
  return response;
}

void SolveEquilibriumService::writeReport(const Request& request, const SolverContext::Trial& trial,
                                          const cable_variation::DesignValues& values,
                                          const std::vector<cable_variation::MeasureValue>& measured,
                                          Response& response) const {
  const std::string page = equilibriumPage(fromMessage(request), context_.origin(), context_.design(), values,
                                           trial, measured, context_.parts());
  response.report_file = writeBeside(output_, request.report, ".html", page, response.status);
}

}  // namespace cable_variation_ros
