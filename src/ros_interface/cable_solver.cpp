#include <ros_interface/cable_solver.h>

#include <ros/callback_queue.h>
#include <ros/console.h>

#include <cable_variation/scene/enum_names.h>
#include <ros_interface/conversion/scene_loading.h>
#include <ros_interface/node/names.h>
#include <ros_interface/node/node_end.h>

namespace cable_variation_ros {

namespace {

/// A service cannot be cancelled, but the node ends.
bool whileNodeRuns(const cable_variation::Progress& /*progress*/) { return goesOn(); }

void warnOfDriven(const cable_variation::Scene& scene) {
  for (const cable_variation::Component& component : scene.components) {
    if (component.driven_by == cable_variation::ComponentDriver::scene || component.joint) continue;
    ROS_WARN("component '%s' is driven by %s, which is not followed: ~live is false", component.name.c_str(),
             nameOf(component.driven_by));
  }
}

}  // namespace

CableSolver::CableSolver(ros::NodeHandle node, const CableSolverParameters& parameters)
    : node_(std::move(node)),
      context_(loadScene(parameters.scene, parameters.limits), parameters.limits),
      state_(node_, parameters.state_file, parameters.scene),
      measured_(context_),
      spinning_(*ros::getGlobalCallbackQueue()),
      interference_(node_),
      publisher_(node_, interference_),
      live_publisher_(node_, parameters.live_topics),
      events_(node_),
      tubes_(node_),
      variation_(node_, tubes_),
      envelope_(node_, interference_),
      path_(node_, interference_),
      design_state_(node_),
      diagnostics_(node_, context_),
      solve_equilibrium_(node_, context_, cable_variation::OutputDirectory(parameters.output_directory),
                         names_),
      analyze_stability_(node_, context_, variation_,
                         cable_variation::OutputDirectory(parameters.output_directory), names_),
      get_scene_(node_, context_),
      load_scene_(node_, context_),
      save_scene_(node_, context_, cable_variation::OutputDirectory(parameters.output_directory), names_),
      design_(node_, context_),
      set_attachment_(node_, context_, {shape_watch_, measured_}),
      check_forbidden_region_(node_, context_, interference_,
                              cable_variation::OutputDirectory(parameters.output_directory)),
      check_path_(node_, context_, spinning_, path_,
                  cable_variation::OutputDirectory(parameters.output_directory), names_),
      runner_(context_, spinning_, names_,
              {parameters.threads, parameters.memory_limit,
               cable_variation::OutputDirectory(parameters.output_directory), parameters.memory_total}),
      envelopes_(runner_, envelope_, kGenerateEnvelopeService),
      generate_envelope_(node_, kGenerateEnvelopeService,
                         [this](const cable_variation::GenerateEnvelopeRequest& request) {
                           return envelopes_.run(request, whileNodeRuns);
                         }),
      generate_envelope_action_(node_, kGenerateEnvelopeAction, envelopes_),
      simulations_(runner_, variation_, kSimulateVariationService),
      simulate_variation_(node_, kSimulateVariationService,
                          [this](const cable_variation::SimulateVariationRequest& request) {
                            return simulations_.run(request, whileNodeRuns);
                          }),
      simulate_variation_action_(node_, kSimulateVariationAction, simulations_) {
  context_.setAuthor(parameters.author);
  state_.restore(context_);
  if (parameters.interactive) {
    drags_ = std::make_unique<DragServer>(
        node_, context_, [this](const std::vector<std::string>& variables) { analyse(variables); });
  }
  logWarnings(context_.design().scene);
  context_.onChange([this] { show(); });
  context_.onConfirm([this] { showAgain(); });
  show();
  ROS_INFO("cable_solver is up with %s: %zu cables, %zu clips, %s", context_.design().scene.source.c_str(),
           context_.harness().cables.size(), context_.harness().clips.size(),
           context_.harness().cables.empty()    ? "nothing to solve yet"
           : context_.equilibrium().converged() ? "in equilibrium"
                                                : "without an equilibrium");
  if (parameters.live) {
    const TfFollowerOptions options{parameters.live_rate_hz, parameters.tf_timeout};
    follower_ = std::make_unique<TfFollower>(
        node_, context_, options,
        [this](const std::vector<cable_variation::CableEvent>& events) { events_.publish(events); });
    attachments_ = std::make_unique<AttachmentFollower>(
        node_, context_,
        [this](const std::vector<cable_variation::CableEvent>& events) { events_.publish(events); });
    diagnostics_.watchTf([this] { return follower_->late(); });
  } else {
    warnOfDriven(context_.design().scene);
  }
}

CableSolver::~CableSolver() { spinning_.stop(); }  // runs that wait for it end

void CableSolver::analyse(const std::vector<std::string>& variables) {
  AnalyzeStabilityService::Request request;
  AnalyzeStabilityService::Response response;
  request.variables = variables;
  request.skip_low_high = true;
  analyze_stability_.handle(request, response);
  if (response.status.code == cable_variation::Status::SUCCESS) {
    ROS_INFO("shown: what %s does to the cables", response.shown.c_str());
  } else {
    ROS_WARN("%s: %s", kAnalyzeStabilityService, response.status.message.c_str());
  }
}

void CableSolver::showAgain() {
  constexpr double kOften = 0.1;  // [s]
  const ros::WallTime now = ros::WallTime::now();
  if (now - shown_ < ros::WallDuration(kOften)) return;
  shown_ = now;
  live_publisher_.publish(context_, measured_.values());
}

void CableSolver::show() {
  shown_ = ros::WallTime::now();
  const cable_variation::Equilibrium& equilibrium = context_.equilibrium();
  if (!equilibrium.converged() && !context_.harness().cables.empty()) {
    ROS_ERROR_THROTTLE(5.0, "%s: %s", toString(equilibrium.status), equilibrium.message.c_str());
  }
  design_state_.contextChanged(context_);
  measured_.contextChanged();
  publisher_.publish(context_, measured_.values());
  live_publisher_.publish(context_, measured_.values());
  clip_frames_.publish(context_);
  events_.publish(shape_watch_.eventsOf(context_, measured_.values()));
  variation_.contextChanged();
  tubes_.publish(context_);
  envelope_.contextChanged(context_);
  path_.contextChanged(context_);
  check_forbidden_region_.contextChanged();
  if (drags_) drags_->contextChanged();
  diagnostics_.contextChanged();
  state_.contextChanged(context_);
}

}  // namespace cable_variation_ros
