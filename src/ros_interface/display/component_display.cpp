#include <ros_interface/display/component_display.h>

#include <algorithm>
#include <utility>

#include <ros/console.h>
#include <ros/node_handle.h>

#include <ros_interface/conversion/component_deviations.h>
#include <ros_interface/markers/component_markers.h>
#include <ros_interface/node/names.h>

namespace cable_variation_ros {

namespace {

constexpr double kFirstPause = 2.0, kLongestPause = 60.0;  // [s]

}  // namespace

ComponentDisplay::ComponentDisplay(ros::NodeHandle& node)
    : markers_(node, kComponentsTopic),
      deviations_(node.subscribe(kComponentDeviationsTopic, 1, &ComponentDisplay::deviate, this)),
      again_(node.createWallTimer(
          ros::WallDuration(kFirstPause), [this](const ros::WallTimerEvent&) { repeat(); }, false, false)) {}

void ComponentDisplay::show(std::shared_ptr<const cable_variation::Scene> scene,
                            std::set<std::string> which) {
  scene_ = std::move(scene);
  which_ = std::move(which);
  deviations_shown_.clear();
  publish();
  again_.stop();
  const auto placed_by_others = [](const cable_variation::Component& component) {
    return component.driven_by != cable_variation::ComponentDriver::scene;
  };
  if (std::none_of(scene_->components.begin(), scene_->components.end(), placed_by_others)) return;
  pause_ = kFirstPause;
  again_.setPeriod(ros::WallDuration(pause_));
  again_.start();
}

void ComponentDisplay::publish() { markers_.publish(componentMarkers(*scene_, which_, deviations_shown_)); }

void ComponentDisplay::repeat() {
  publish();
  pause_ = std::min(2.0 * pause_, kLongestPause);
  again_.setPeriod(ros::WallDuration(pause_));
}

void ComponentDisplay::deviate(const cable_variation::ComponentDeviations& message) {
  if (!scene_) return;
  try {
    deviations_shown_ = fromMessage(message);
    publish();
  } catch (const std::invalid_argument& error) {
    ROS_WARN_THROTTLE(5.0, "%s", error.what());
  }
}

}  // namespace cable_variation_ros
