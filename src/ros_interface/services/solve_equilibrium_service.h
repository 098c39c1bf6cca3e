#pragma once

#include <vector>

#include <ros/service_server.h>

#include <cable_variation/SolveEquilibrium.h>

#include <ros_interface/context/solver_context.h>
#include <cable_variation/analysis/output_directory.h>

namespace ros {
class NodeHandle;
}

namespace cable_variation_ros {

class NameRegistry;

/// ~solve_equilibrium
class SolveEquilibriumService {
 public:
  SolveEquilibriumService(ros::NodeHandle& node, const SolverContext& context,
                          const cable_variation::OutputDirectory& output, NameRegistry& names);

 private:
  using Request = cable_variation::SolveEquilibriumRequest;
  using Response = cable_variation::SolveEquilibriumResponse;
  bool handle(Request& request, Response& response);
  Response solve(const Request& request);
  void writeReport(const Request& request, const SolverContext::Trial& trial,
                   const cable_variation::DesignValues& values,
                   const std::vector<cable_variation::MeasureValue>& measured, Response& response) const;

  const SolverContext& context_;
  cable_variation::OutputDirectory output_;
  NameRegistry& names_;
  ros::ServiceServer server_;
};

}  // namespace cable_variation_ros
