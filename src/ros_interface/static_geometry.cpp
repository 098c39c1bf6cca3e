#include <ros_interface/static_geometry.h>

#include <cable_variation/scene/moving_components.h>
#include <ros_interface/conversion/message_conversion.h>
#include <ros_interface/conversion/scene_loading.h>
#include <ros_interface/node/names.h>

namespace cable_variation_ros {

StaticGeometry::StaticGeometry(ros::NodeHandle node, const StaticGeometryParameters& parameters)
    : scene_(loadScene(parameters.scene)) {
  const std::set<std::string> moving = movingComponents(scene_);
  std::set<std::string> fixed;
  const ros::Time now = ros::Time::now();
  std::vector<geometry_msgs::TransformStamped> transforms = {
      toTransform(cable_variation::Pose(), kWorldFrame, kSceneFrame, now)};
  for (const cable_variation::Component& component : scene_.components) {
    if (moving.count(component.name) != 0) continue;
    fixed.insert(component.name);
    transforms.push_back(toTransform(component.pose, component.parent, component.name, now));
  }
  broadcaster_.sendTransform(transforms);
  display_ = std::make_unique<ComponentDisplay>(node, scene_, fixed);
}

}  // namespace cable_variation_ros
