#include <ros_interface/cable_solver.h>

#include <ros/callback_queue.h>
#include <ros/console.h>

#include <ros_interface/conversion/scene_loading.h>
#include <ros_interface/node/names.h>

namespace cable_variation_ros {

CableSolver::CableSolver(ros::NodeHandle node, const CableSolverParameters& parameters)
    : node_(std::move(node)),
      context_(loadScene(parameters.scene)),
      spinning_(*ros::getGlobalCallbackQueue()),
      interference_(node_),
      publisher_(node_, interference_),
      variation_(node_),
      envelope_(node_, interference_),
      diagnostics_(node_, context_),
      solve_equilibrium_(node_, context_),
      analyze_stability_(node_, context_, variation_, OutputDirectory(parameters.output_directory), names_),
      get_scene_(node_, context_),
      load_scene_(node_, context_),
      design_(node_, context_),
      check_forbidden_region_(node_, context_, interference_, OutputDirectory(parameters.output_directory)),
      envelope_runner_(context_, envelope_, spinning_, OutputDirectory(parameters.output_directory), names_,
                       parameters.threads, parameters.memory_limit),
      generate_envelope_(node_, kGenerateEnvelopeService,
                         [this](const cable_variation::GenerateEnvelopeRequest& request) {
                           return envelope_runner_.run(request, [](const RunProgress&) { return ros::ok(); });
                         }),
      generate_envelope_action_(node_, envelope_runner_),
      simulation_runner_(context_, variation_, spinning_, OutputDirectory(parameters.output_directory),
                         names_, parameters.threads, parameters.memory_limit),
      simulate_variation_(node_, kSimulateVariationService,
                          [this](const cable_variation::SimulateVariationRequest& request) {
                            return simulation_runner_.run(
                                request, [](const cable_variation::SimulationProgress&,
                                            const std::vector<std::string>&) { return ros::ok(); });
                          }),
      simulate_variation_action_(node_, simulation_runner_) {
  logWarnings(context_.design().scene);
  context_.onChange([this] { show(); });
  show();
  if (parameters.live) {
    follower_ = std::make_unique<TfFollower>(node_, context_, parameters.live_rate_hz);
  }
}

CableSolver::~CableSolver() { spinning_.stop(); }  // runs that wait for it end

void CableSolver::show() {
  const cable_variation::Equilibrium& equilibrium = context_.equilibrium();
  if (!equilibrium.converged()) {
    ROS_ERROR_THROTTLE(5.0, "%s: %s", toString(equilibrium.status), equilibrium.message.c_str());
  }
  publisher_.publish(context_);
  variation_.contextChanged();
  envelope_.contextChanged(context_);
  check_forbidden_region_.contextChanged();
  diagnostics_.contextChanged();
}

}  // namespace cable_variation_ros
