#pragma once

#include <ros/service_server.h>

#include <cable_variation/GetScene.h>
#include <cable_variation/measures/open_parts.h>

namespace ros {
class NodeHandle;
}

namespace cable_variation_ros {

class SolverContext;

/// ~get_scene
class GetSceneService {
 public:
  GetSceneService(ros::NodeHandle& node, const SolverContext& context);

 private:
  bool handle(cable_variation::GetSceneRequest& request, cable_variation::GetSceneResponse& response);

  const SolverContext& context_;
  cable_variation::ComponentOpenness openness_;
  ros::ServiceServer server_;
};

}  // namespace cable_variation_ros
