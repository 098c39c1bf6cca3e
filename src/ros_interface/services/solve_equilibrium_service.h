#pragma once

#include <ros/service_server.h>

#include <cable_variation/SolveEquilibrium.h>

namespace ros {
class NodeHandle;
}

namespace cable_variation_ros {

class SolverContext;

/// ~solve_equilibrium
class SolveEquilibriumService {
 public:
  SolveEquilibriumService(ros::NodeHandle& node, const SolverContext& context);

 private:
  using Request = cable_variation::SolveEquilibriumRequest;
  using Response = cable_variation::SolveEquilibriumResponse;
  bool handle(Request& request, Response& response);

  const SolverContext& context_;
  ros::ServiceServer server_;
};

}  // namespace cable_variation_ros
