#pragma once

#include <ros/service_server.h>

#include <cable_variation/CheckForbiddenRegion.h>

#include <cable_variation/analysis/output_directory.h>

namespace ros {
class NodeHandle;
}

namespace cable_variation_ros {

class InterferencePublisher;
class SolverContext;

/// ~check_forbidden_region
class CheckForbiddenRegionService {
 public:
  CheckForbiddenRegionService(ros::NodeHandle& node, const SolverContext& context,
                              InterferencePublisher& interference,
                              const cable_variation::OutputDirectory& output);

  /// What was shown may no longer be where it was.
  void contextChanged();

 private:
  using Request = cable_variation::CheckForbiddenRegionRequest;
  using Response = cable_variation::CheckForbiddenRegionResponse;
  bool handle(Request& request, Response& response);
  Response check(const Request& request);

  const SolverContext& context_;
  InterferencePublisher& interference_;
  cable_variation::OutputDirectory output_;
  bool showing_ = false;
  ros::ServiceServer server_;
};

}  // namespace cable_variation_ros
