#include <ros_interface/display/design_publisher.h>

#include <filesystem>

#include <ros/node_handle.h>

#include <cable_variation/DesignState.h>

#include <ros_interface/node/names.h>

namespace cable_variation_ros {

DesignPublisher::DesignPublisher(ros::NodeHandle& node)
    : publisher_(node.advertise<cable_variation::DesignState>(kDesignTopic, 1, true)) {}

void DesignPublisher::contextChanged(const SolverContext& context) {
  if (shown_ == context.designNumber()) return;
  shown_ = context.designNumber();
  const cable_variation::Scene& scene = context.design().scene;
  cable_variation::DesignState state;
  std::error_code ignored;
  state.source = std::filesystem::absolute(scene.source, ignored).string();
  state.loads = static_cast<std::uint32_t>(context.loads());
  state.edited = context.edited();
  for (std::size_t i = 0; i < scene.design_variables.size(); ++i) {
    state.variables.push_back(scene.design_variables[i].name);
    state.nominal.push_back(scene.design_variables[i].nominal);
    state.loaded.push_back(context.loaded().design_variables[i].nominal);
  }
  publisher_.publish(state);
}

}  // namespace cable_variation_ros
