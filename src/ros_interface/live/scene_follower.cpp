#include <ros_interface/live/scene_follower.h>

#include <exception>
#include <filesystem>

#include <ros/console.h>
#include <ros/node_handle.h>

#include <ros_interface/node/names.h>

namespace cable_variation_ros {

SceneFollower::SceneFollower(ros::NodeHandle& node, std::string loaded,
                             std::function<void(const std::string&)> load)
    : loaded_(std::move(loaded)),
      load_(std::move(load)),
      subscriber_(node.subscribe(kDesignTopic, 1, &SceneFollower::hear, this)) {}

void SceneFollower::hear(const cable_variation::DesignState& state) {
  const std::pair<std::string, std::uint32_t> now(state.source, state.loads);
  if (followed_ == now) return;
  const bool first = !followed_;
  followed_ = now;
  std::error_code ignored;
  if (first && state.loads == 0 && std::filesystem::equivalent(loaded_, state.source, ignored)) return;
  try {
    load_(state.source);
  } catch (const std::exception& error) {
    ROS_ERROR("the scene that %s tells of: %s", subscriber_.getTopic().c_str(), error.what());
  }
}

}  // namespace cable_variation_ros
