#pragma once

#include <functional>
#include <string>
#include <vector>

#include <diagnostic_updater/diagnostic_updater.h>
#include <ros/wall_timer.h>

namespace ros {
class NodeHandle;
}

namespace cable_variation_ros {

class SolverContext;

/// How the last solve went, implausible values in the scene and what tf is late, on /diagnostics: once a
/// second and whenever the status changes.
class SolverDiagnostics {
 public:
  SolverDiagnostics(ros::NodeHandle& node, const SolverContext& context);

  void contextChanged();
  /// @param late what is late on tf now, a sentence each
  void watchTf(std::function<std::vector<std::string>()> late);

 private:
  void report(diagnostic_updater::DiagnosticStatusWrapper& status) const;
  void reportScene(diagnostic_updater::DiagnosticStatusWrapper& status) const;

  const SolverContext& context_;
  diagnostic_updater::Updater updater_;
  ros::WallTimer timer_;
  bool converged_;  ///< when last looked at
};

}  // namespace cable_variation_ros
