#include <ros_interface/services/get_scene_service.h>

#include <ros/node_handle.h>

#include <ros_interface/context/solver_context.h>
#include <ros_interface/conversion/scene_conversion.h>
#include <ros_interface/node/names.h>
#include <ros_interface/request/request_status.h>

namespace cable_variation_ros {

GetSceneService::GetSceneService(ros::NodeHandle& node, const SolverContext& context)
    : context_(context), server_(node.advertiseService(kGetSceneService, &GetSceneService::handle, this)) {}

bool GetSceneService::handle(cable_variation::GetSceneRequest&, cable_variation::GetSceneResponse& response) {
  const cable_variation::Status status = runRequest([&] {
    response = toResponse(context_.design(), context_.moved());
    const auto& components = context_.design().scene.components;
    for (std::size_t i = 0; i < components.size(); ++i) {
      const cable_variation::PartOpenness openness = openness_.of(components[i]);
      response.components[i].open_edges = static_cast<std::uint32_t>(openness.edges);
      response.components[i].open_length = openness.length;
    }
  });
  response.status = status;
  return true;
}

}  // namespace cable_variation_ros
