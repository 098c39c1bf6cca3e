#include <ros_interface/cable_solver.h>

#include <ros/console.h>

#include <ros_interface/scene_loading.h>

namespace cable_variation_ros {

CableSolver::CableSolver(ros::NodeHandle node, const CableSolverParameters& parameters)
    : node_(std::move(node)),
      context_(loadScene(parameters.scene)),
      interference_(node_),
      publisher_(node_, interference_),
      variation_(node_),
      diagnostics_(node_, context_),
      solve_equilibrium_(node_, context_),
      analyze_stability_(node_, context_, variation_, OutputDirectory(parameters.output_directory)),
      get_scene_(node_, context_),
      load_scene_(node_, context_),
      design_(node_, context_) {
  context_.onChange([this] { show(); });
  show();
  if (parameters.live) {
    follower_ = std::make_unique<TfFollower>(node_, context_, parameters.live_rate_hz);
  }
}

void CableSolver::show() {
  const cable_variation::Equilibrium& equilibrium = context_.equilibrium();
  if (!equilibrium.converged()) {
    ROS_ERROR_THROTTLE(5.0, "%s: %s", toString(equilibrium.status), equilibrium.message.c_str());
  }
  publisher_.publish(context_);
  analyze_stability_.contextChanged();
  diagnostics_.contextChanged();
}

}  // namespace cable_variation_ros
