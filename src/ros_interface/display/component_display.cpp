#include <ros_interface/display/component_display.h>

#include <utility>

#include <ros/console.h>
#include <ros/node_handle.h>

#include <ros_interface/conversion/component_deviations.h>
#include <ros_interface/markers/component_markers.h>
#include <ros_interface/node/names.h>

namespace cable_variation_ros {

ComponentDisplay::ComponentDisplay(ros::NodeHandle& node)
    : markers_(node, kComponentsTopic),
      deviations_(node.subscribe(kComponentDeviationsTopic, 1, &ComponentDisplay::deviate, this)) {}

void ComponentDisplay::show(std::shared_ptr<const cable_variation::Scene> scene,
                            std::set<std::string> which) {
  scene_ = std::move(scene);
  which_ = std::move(which);
  markers_.publish(componentMarkers(*scene_, which_, {}));
}

void ComponentDisplay::deviate(const cable_variation::ComponentDeviations& message) {
  if (!scene_) return;
  try {
    markers_.publish(componentMarkers(*scene_, which_, fromMessage(message)));
  } catch (const std::invalid_argument& error) {
    ROS_WARN_THROTTLE(5.0, "%s", error.what());
  }
}

}  // namespace cable_variation_ros
