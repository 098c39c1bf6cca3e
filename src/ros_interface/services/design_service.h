#pragma once

#include <ros/service_server.h>
#include <std_srvs/Trigger.h>

#include <cable_variation/SetDesign.h>

namespace ros {
class NodeHandle;
}

namespace cable_variation_ros {

class SolverContext;

/// ~set_design and ~reset_design
class DesignService {
 public:
  DesignService(ros::NodeHandle& node, SolverContext& context);

 private:
  bool set(cable_variation::SetDesignRequest& request, cable_variation::SetDesignResponse& response);
  bool reset(std_srvs::TriggerRequest& request, std_srvs::TriggerResponse& response);

  SolverContext& context_;
  ros::ServiceServer set_server_;
  ros::ServiceServer reset_server_;
};

}  // namespace cable_variation_ros
