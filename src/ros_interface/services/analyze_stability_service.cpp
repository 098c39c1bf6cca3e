#include <ros_interface/services/analyze_stability_service.h>

#include <algorithm>

#include <ros/node_handle.h>

#include <cable_variation/analysis/design_stability.h>
#include <cable_variation/analysis/name_lookup.h>
#include <cable_variation/equilibrium/require_converged.h>
#include <cable_variation/report/stability_section.h>
#include <cable_variation/sensitivity/most_telling_variable.h>
#include <ros_interface/context/solver_context.h>
#include <ros_interface/conversion/component_deviations.h>
#include <ros_interface/conversion/stability_conversion.h>
#include <ros_interface/display/variation_publisher.h>
#include <ros_interface/markers/component_variation_markers.h>
#include <ros_interface/markers/sensitivity_markers.h>
#include <ros_interface/node/names.h>
#include <ros_interface/request/name_registry.h>
#include <ros_interface/request/request_status.h>
#include <ros_interface/runs/report_file.h>
#include <ros_interface/runs/requests.h>

namespace cable_variation_ros {

using cable_variation::ComponentPoses;
using cable_variation::ComponentVariation;
using cable_variation::DesignVariable;
using cable_variation::Scene;
using cable_variation::StabilityAnalysis;
using cable_variation::StabilityOptions;

namespace {

/// The column whose effect is to be shown: the one asked for, or the one worth
/// looking at first; none if components are shown.
std::optional<std::size_t> shownColumn(const cable_variation::AnalyzeStabilityRequest& request,
                                       const Scene& scene, const StabilityAnalysis& analysis) {
  if (request.show_components) return std::nullopt;
  if (request.show.empty()) return mostTellingVariable(scene, analysis);
  for (std::size_t j = 0; j < analysis.variables.size(); ++j) {
    if (scene.design_variables[analysis.variables[j]].name == request.show) return j;
  }
  throw std::invalid_argument("show: '" + request.show + "' is not among the variables analysed");
}

}  // namespace

AnalyzeStabilityService::AnalyzeStabilityService(ros::NodeHandle& node, const SolverContext& context,
                                                 VariationPublisher& publisher,
                                                 const cable_variation::OutputDirectory& output,
                                                 NameRegistry& names)
    : context_(context),
      publisher_(publisher),
      output_(output),
      names_(names),
      server_(node.advertiseService(kAnalyzeStabilityService, &AnalyzeStabilityService::handle, this)) {}

bool AnalyzeStabilityService::handle(Request& request, Response& response) {
  response = answered<Response>([&] { return analyse(request); });
  return true;
}

void AnalyzeStabilityService::follow(const std::string& variable) {
  const std::vector<DesignVariable>& variables = context_.design().scene.design_variables;
  const auto found = std::find_if(variables.begin(), variables.end(),
                                  [&](const DesignVariable& each) { return each.name == variable; });
  if (found == variables.end() || !context_.equilibrium().converged()) {
    publisher_.hide();
    return;
  }
  const auto index = static_cast<std::size_t>(found - variables.begin());
  const SensitivityView view =
      sensitivityView(*found, context_.harness(), context_.equilibrium(), context_.shapeRate(index));
  publisher_.show(view.markers, view.tubes, view.legend, [this, variable] { follow(variable); });
}

AnalyzeStabilityService::Response AnalyzeStabilityService::analyse(const Request& request) {
  if (!request.report.empty()) cable_variation::OutputDirectory::checkName(request.report);
  const NameRegistry::Hold hold(names_, "report", request.report, kAnalyzeStabilityService);
  const cable_variation::Design& design = context_.design();
  const Scene& scene = design.scene;
  StabilityOptions options = toStabilityOptions(fromMessage(request), scene);
  if (!request.show.empty()) indicesOf({request.show}, scene.design_variables, "design variable");
  const StabilityAnalysis analysis = context_.analyse(options);
  requireConverged(analysis.nominal);

  const std::optional<std::size_t> column = shownColumn(request, scene, analysis);

  const ComponentPoses poses = componentPosesAt(scene, options.values, options.moved);
  const std::vector<ComponentVariation> components = componentVariations(scene, options);
  Response response = toResponse(scene, options.values, analysis, components, poses);
  if (!request.report.empty()) writeReport(request, scene, analysis, options, response);

  if (request.show_components) {
    const ComponentVariationView view = componentVariationMarkers(
        scene, components, poses, componentDeviations(scene, options.values, options.moved, context_.onTf()));
    publisher_.show(view.markers, {}, view.legend, nullptr);
  } else if (column) {
    const DesignVariable& variable = scene.design_variables[analysis.variables[*column]];
    const cable_variation::Harness harness = harnessAt(scene, options.values, options.moved);
    const SensitivityView view =
        sensitivityView(variable, harness, analysis.nominal, analysis.rates[*column]);
    std::function<void()> renew;
    if (request.nominal_variables.empty()) renew = [this, name = variable.name] { follow(name); };
    publisher_.show(view.markers, view.tubes, view.legend, renew);
    response.shown = variable.name;
  } else {
    publisher_.clear();
  }
  return response;
}

void AnalyzeStabilityService::writeReport(const Request& request, const Scene& scene,
                                          const StabilityAnalysis& analysis, const StabilityOptions& options,
                                          Response& response) const {
  response.report_file =
      writeBeside(output_, request.report, ".html",
                  stabilityPage(context_.origin(), scene, analysis, options), response.status);
  const std::string csv = stabilityCsv(scene, analysis, options.values);
  response.csv_file = writeBeside(output_, request.report, ".csv", csv, response.status);
}

}  // namespace cable_variation_ros
