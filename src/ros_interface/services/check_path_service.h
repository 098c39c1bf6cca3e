#pragma once

#include <functional>

#include <cable_variation/CheckPath.h>

#include <cable_variation/analysis/output_directory.h>
#include <ros_interface/node/own_thread_service.h>

namespace cable_variation_ros {

class NameRegistry;
class PathPublisher;
class SolverContext;
class SpinningThread;

/// ~check_path, on a thread of its own: others are answered meanwhile.
class CheckPathService {
 public:
  /// All must outlive it.
  CheckPathService(const ros::NodeHandle& node, const SolverContext& context, SpinningThread& spinning,
                   PathPublisher& publisher, const cable_variation::OutputDirectory& output,
                   NameRegistry& names);

 private:
  using Request = cable_variation::CheckPathRequest;
  using Response = cable_variation::CheckPathResponse;
  Response answer(const Request& request);
  Response check(const Request& request);

  const SolverContext& context_;
  SpinningThread& spinning_;
  PathPublisher& publisher_;
  cable_variation::OutputDirectory output_;
  NameRegistry& names_;
  OwnThreadService<cable_variation::CheckPath> server_;
};

}  // namespace cable_variation_ros
