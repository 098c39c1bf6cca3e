#include <ros_interface/static_geometry.h>

#include <ros/console.h>

#include <cable_variation/scene/moving_components.h>
#include <ros_interface/conversion/message_conversion.h>
#include <ros_interface/conversion/scene_loading.h>
#include <ros_interface/node/names.h>

namespace cable_variation_ros {

using cable_variation::Scene;

StaticGeometry::StaticGeometry(ros::NodeHandle node, const StaticGeometryParameters& parameters)
    : limits_(parameters.limits),
      display_(node),
      follower_(node, parameters.scene, [this](const std::string& address) { load(address); }) {
  if (parameters.scene.empty()) {
    show(std::make_shared<const Scene>());
    ROS_INFO("static_geometry_node is up, waiting for a scene on %s", node.resolveName(kDesignTopic).c_str());
  } else {
    load(parameters.scene);
  }
}

void StaticGeometry::load(const std::string& address) {
  show(std::make_shared<const Scene>(loadScene(address, limits_)));
}

void StaticGeometry::show(std::shared_ptr<const Scene> scene) {
  const std::set<std::string> moving = movingComponents(*scene);
  std::set<std::string> fixed;
  const ros::Time now = ros::Time::now();
  std::vector<geometry_msgs::TransformStamped> transforms = {
      toTransform(cable_variation::Pose(), kWorldFrame, kSceneFrame, now)};
  for (const cable_variation::Component& component : scene->components) {
    if (moving.count(component.name) != 0) continue;
    fixed.insert(component.name);
    if (component.driven_by == cable_variation::ComponentDriver::tf) continue;
    transforms.push_back(toTransform(component.pose, component.parent, component.name, now));
  }
  // A new one: the old one would go on telling of the frames of the scene before.
  broadcaster_.reset();
  broadcaster_ = std::make_unique<tf2_ros::StaticTransformBroadcaster>();
  broadcaster_->sendTransform(transforms);
  if (!scene->source.empty()) {
    ROS_INFO("static_geometry_node shows %zu components of %s", fixed.size(), scene->source.c_str());
  }
  display_.show(std::move(scene), std::move(fixed));
}

}  // namespace cable_variation_ros
