#pragma once

#include <diagnostic_updater/diagnostic_updater.h>
#include <ros/wall_timer.h>

namespace ros {
class NodeHandle;
}

namespace cable_variation_ros {

class SolverContext;

/// How the last solve went, and implausible values in the scene, on /diagnostics: once a second and whenever
/// the status changes.
class SolverDiagnostics {
 public:
  SolverDiagnostics(ros::NodeHandle& node, const SolverContext& context);

  void contextChanged();

 private:
  void report(diagnostic_updater::DiagnosticStatusWrapper& status) const;
  void reportScene(diagnostic_updater::DiagnosticStatusWrapper& status) const;

  const SolverContext& context_;
  diagnostic_updater::Updater updater_;
  ros::WallTimer timer_;
  bool converged_;  ///< when last looked at
};

}  // namespace cable_variation_ros
