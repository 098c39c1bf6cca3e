#include <ros_interface/context/solver_diagnostics.h>

#include <optional>

#include <ros/node_handle.h>

#include <cable_variation/util/heap_use.h>
#include <ros_interface/context/solver_context.h>
#include <ros_interface/conversion/scene_loading.h>

namespace cable_variation_ros {

namespace {

void reportMemory(diagnostic_updater::DiagnosticStatusWrapper& status) {
  constexpr double kMegabyte = 1e6;
  const std::optional<cable_variation::HeapUse> use = cable_variation::heapUse();
  status.summary(diagnostic_msgs::DiagnosticStatus::OK, use ? "of the heap" : "not known");
  if (!use) return;
  status.add("live [MB]", static_cast<double>(use->live) / kMegabyte);
  status.add("held [MB]", static_cast<double>(use->held) / kMegabyte);
}

}  // namespace

SolverDiagnostics::SolverDiagnostics(ros::NodeHandle& node, const SolverContext& context)
    : context_(context), converged_(context.equilibrium().converged()) {
  updater_.setHardwareID("none");
  updater_.add("equilibrium",
               [this](diagnostic_updater::DiagnosticStatusWrapper& status) { report(status); });
  updater_.add("scene", [this](diagnostic_updater::DiagnosticStatusWrapper& status) { reportScene(status); });
  updater_.add("memory", reportMemory);
  timer_ = node.createWallTimer(ros::WallDuration(1.0),
                                [this](const ros::WallTimerEvent&) { updater_.force_update(); });
}

void SolverDiagnostics::watchTf(std::function<std::vector<std::string>()> late) {
  updater_.add("tf", [late](diagnostic_updater::DiagnosticStatusWrapper& status) {
    const std::vector<std::string> texts = late();
    if (texts.empty()) {
      status.summary(diagnostic_msgs::DiagnosticStatus::OK, "what is on it comes in time");
    } else {
      status.summary(diagnostic_msgs::DiagnosticStatus::WARN,
                     texts.front() + (texts.size() > 1 ? " (and others)" : ""));
    }
    for (std::size_t i = 0; i < texts.size(); ++i) status.add("late " + std::to_string(i + 1), texts[i]);
  });
}

void SolverDiagnostics::contextChanged() {
  const bool converged = context_.equilibrium().converged();
  if (converged == converged_) return;
  converged_ = converged;
  updater_.force_update();
}

void SolverDiagnostics::report(diagnostic_updater::DiagnosticStatusWrapper& status) const {
  const cable_variation::Equilibrium& equilibrium = context_.equilibrium();
  if (context_.harness().cables.empty()) {
    status.summary(diagnostic_msgs::DiagnosticStatus::OK, equilibrium.message);
  } else if (equilibrium.converged()) {
    status.summary(diagnostic_msgs::DiagnosticStatus::OK, "stable equilibrium");
  } else {
    status.summary(diagnostic_msgs::DiagnosticStatus::ERROR,
                   std::string(toString(equilibrium.status)) + ": " + equilibrium.message);
  }
  status.add("scene", context_.design().scene.source);
  status.add("cables", context_.harness().cables.size());
  status.add("clips", context_.harness().clips.size());
  status.add("components moved", context_.moved().size());
  status.add("iterations", equilibrium.iterations);
  status.add("residual [N]", equilibrium.residual);
  status.add("discretisation error [m]", equilibrium.discretisation_error);
  status.add("smallest eigenvalue [N/m]", equilibrium.smallest_eigenvalue);
  status.add("energy [J]", equilibrium.energy.total());
  status.add("solve time [s]", equilibrium.solve_time);
  status.add("alternatives", equilibrium.alternatives.size());
}

void SolverDiagnostics::reportScene(diagnostic_updater::DiagnosticStatusWrapper& status) const {
  const std::vector<std::string> warnings = warningsOf(context_.design().scene);
  if (warnings.empty()) {
    status.summary(diagnostic_msgs::DiagnosticStatus::OK, "nothing in it looks like a slip");
  } else {
    status.summary(diagnostic_msgs::DiagnosticStatus::WARN,
                   warnings.front() + (warnings.size() > 1 ? " (and others)" : ""));
  }
  for (std::size_t i = 0; i < warnings.size(); ++i)
    status.add("warning " + std::to_string(i + 1), warnings[i]);
}

}  // namespace cable_variation_ros
