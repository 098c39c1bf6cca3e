#pragma once

#include <string>

#include <ros/service_server.h>

#include <cable_variation/AnalyzeStability.h>

#include <ros_interface/output_directory.h>

namespace ros {
class NodeHandle;
}

namespace cable_variation_ros {

class SolverContext;
class VariationPublisher;

/// ~analyze_stability
class AnalyzeStabilityService {
 public:
  AnalyzeStabilityService(ros::NodeHandle& node, const SolverContext& context, VariationPublisher& publisher,
                          const OutputDirectory& output);

  /// The view goes with the shape in force, or goes away if it shows anything else.
  void contextChanged();

 private:
  using Request = cable_variation::AnalyzeStabilityRequest;
  using Response = cable_variation::AnalyzeStabilityResponse;
  bool handle(Request& request, Response& response);
  Response analyse(const Request& request);

  const SolverContext& context_;
  VariationPublisher& publisher_;
  OutputDirectory output_;
  std::string followed_;  ///< design variable whose effect on the shape in force is shown; empty: none is
  ros::ServiceServer server_;
};

}  // namespace cable_variation_ros
