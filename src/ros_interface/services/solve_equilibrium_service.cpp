#include <ros_interface/services/solve_equilibrium_service.h>

#include <numeric>
#include <sstream>

#include <ros/node_handle.h>

#include <cable_variation/measures/open_parts.h>
#include <cable_variation/scene/moving_components.h>
#include <ros_interface/context/solver_context.h>
#include <ros_interface/conversion/measure_conversion.h>
#include <ros_interface/conversion/message_conversion.h>
#include <ros_interface/node/names.h>
#include <ros_interface/request/design_values.h>
#include <ros_interface/request/name_lookup.h>
#include <ros_interface/request/request_status.h>

namespace cable_variation_ros {

using cable_variation::ComponentPoses;
using cable_variation::Motion;
using cable_variation::Scene;
using cable_variation::Status;

namespace {

ComponentPoses posesOf(const Scene& scene, const std::string& name, double time) {
  const Motion& motion = scene.motions[indexOf(name, scene.motions, "motion")];
  if (!(time >= 0.0 && time <= motion.duration())) {
    std::ostringstream text;
    text << "motion '" << name << "': time " << time << " s, expected 0 to " << motion.duration() << " s";
    throw std::invalid_argument(text.str());
  }
  return posesDuring(scene, {&motion}, time);
}

std::vector<std::size_t> allMeasures(const Scene& scene) {
  std::vector<std::size_t> all(scene.measures.size());
  std::iota(all.begin(), all.end(), std::size_t{0});
  return all;
}

}  // namespace

SolveEquilibriumService::SolveEquilibriumService(ros::NodeHandle& node, const SolverContext& context)
    : context_(context),
      server_(node.advertiseService(kSolveEquilibriumService, &SolveEquilibriumService::handle, this)) {}

bool SolveEquilibriumService::handle(Request& request, Response& response) {
  const Status status = runRequest([&] {
    const Scene& scene = context_.design().scene;
    const cable_variation::DesignValues values = toDesignValues(scene, request.variables, request.values);
    const ComponentPoses moved =
        request.motion.empty() ? context_.moved() : posesOf(scene, request.motion, request.time);
    const SolverContext::Trial trial = context_.solve(values, moved, request.follow);
    Response answer = toResponse(trial.equilibrium, trial.harness);
    const std::vector<std::size_t> all = allMeasures(scene);
    const std::vector<cable_variation::MeasureValue> measured = context_.measure(trial, all);
    for (const std::size_t i : all)
      answer.measures.push_back(toResult(scene.measures[i], measured[i], scene));
    for (std::string& warning : openPartWarnings(scene, context_.parts(), componentsMeasured(scene, all)))
      answer.warnings.push_back(std::move(warning));
    response = std::move(answer);
  });
  response.status = status;
  return true;
}

}  // namespace cable_variation_ros
