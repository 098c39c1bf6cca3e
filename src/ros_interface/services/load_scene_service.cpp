#include <ros_interface/services/load_scene_service.h>

#include <utility>

#include <ros/node_handle.h>

#include <ros_interface/context/solver_context.h>
#include <ros_interface/conversion/scene_loading.h>
#include <ros_interface/node/names.h>
#include <ros_interface/request/request_status.h>

namespace cable_variation_ros {

LoadSceneService::LoadSceneService(ros::NodeHandle& node, SolverContext& context)
    : context_(context), server_(node.advertiseService(kLoadSceneService, &LoadSceneService::handle, this)) {}

bool LoadSceneService::handle(cable_variation::LoadSceneRequest& request,
                              cable_variation::LoadSceneResponse& response) {
  response.status = runRequest([&] {
    cable_variation::Scene scene = loadScene(request.scene, context_.limits());
    response.warnings = warningsOf(scene);
    logWarnings(scene);
    context_.load(std::move(scene));
  });
  return true;
}

}  // namespace cable_variation_ros
