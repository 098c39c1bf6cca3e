#pragma once

#include <functional>
#include <optional>
#include <string>
#include <utility>

#include <ros/subscriber.h>

#include <cable_variation/DesignState.h>

namespace ros {
class NodeHandle;
}

namespace cable_variation_ros {

/// Tells a node of the scene that a cable_solver has in force, by ~design: the launch files connect it to the
/// solver's.
class SceneFollower {
 public:
  /// @param loaded path of the scene that the node has loaded itself; empty: none
  /// @param load called with the path of another scene, and with the same when it was loaded again. What it
  ///   throws is logged
  SceneFollower(ros::NodeHandle& node, std::string loaded, std::function<void(const std::string&)> load);

 private:
  void hear(const cable_variation::DesignState& state);

  std::string loaded_;
  std::optional<std::pair<std::string, std::uint32_t>> followed_;  ///< path and DesignState::loads
  std::function<void(const std::string&)> load_;
  ros::Subscriber subscriber_;
};

}  // namespace cable_variation_ros
