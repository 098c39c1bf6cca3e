#pragma once

#include <string>

#include <ros/service_server.h>

#include <cable_variation/AnalyzeStability.h>

#include <cable_variation/sensitivity/stability_analysis.h>
#include <cable_variation/analysis/output_directory.h>

namespace ros {
class NodeHandle;
}

namespace cable_variation_ros {

class NameRegistry;
class SolverContext;
class VariationPublisher;

/// ~analyze_stability
class AnalyzeStabilityService {
 public:
  AnalyzeStabilityService(ros::NodeHandle& node, const SolverContext& context, VariationPublisher& publisher,
                          const cable_variation::OutputDirectory& output, NameRegistry& names);

  using Request = cable_variation::AnalyzeStabilityRequest;
  using Response = cable_variation::AnalyzeStabilityResponse;
  /// Answers a request, and shows what it asks for.
  bool handle(Request& request, Response& response);

 private:
  Response analyse(const Request& request);
  /// Writes the files: what cannot be written is told in the status.
  void writeReport(const Request& request, const cable_variation::Scene& scene,
                   const cable_variation::StabilityAnalysis& analysis,
                   const cable_variation::StabilityOptions& options, Response& response) const;
  /// Shows the effect of a design variable on the shape in force, while there is one.
  void follow(const std::string& variable);

  const SolverContext& context_;
  VariationPublisher& publisher_;
  cable_variation::OutputDirectory output_;
  NameRegistry& names_;
  ros::ServiceServer server_;
};

}  // namespace cable_variation_ros
