#pragma once

#include <ros/service_server.h>

#include <cable_variation/LoadScene.h>

namespace ros {
class NodeHandle;
}

namespace cable_variation_ros {

class SolverContext;

/// ~load_scene
class LoadSceneService {
 public:
  LoadSceneService(ros::NodeHandle& node, SolverContext& context);

 private:
  bool handle(cable_variation::LoadSceneRequest& request, cable_variation::LoadSceneResponse& response);

  SolverContext& context_;
  ros::ServiceServer server_;
};

}  // namespace cable_variation_ros
