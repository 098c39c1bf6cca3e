#include <ros_interface/moving_geometry.h>

#include <algorithm>
#include <map>
#include <stdexcept>

#include <cable_variation/scene/moving_components.h>
#include <ros_interface/conversion/message_conversion.h>
#include <ros_interface/conversion/scene_loading.h>
#include <ros_interface/node/names.h>
#include <ros_interface/request/request_status.h>

namespace cable_variation_ros {

using cable_variation::Component;
using cable_variation::Motion;
using cable_variation::Scene;

namespace {

Scene loadMotions(const std::string& address) {
  Scene scene = loadScene(address);
  std::map<std::string, std::string> mover;
  for (const Motion& motion : scene.motions) {
    const auto [other, first] = mover.emplace(motion.component, motion.name);
    if (!first) {
      throw std::invalid_argument("motions '" + other->second + "' and '" + motion.name +
                                  "' both move component '" + motion.component + "', expected one");
    }
  }
  return scene;
}

double longest(const Scene& scene) {
  double duration = 0.0;
  for (const Motion& motion : scene.motions) duration = std::max(duration, motion.duration());
  return duration;
}

const Component& componentOf(const Scene& scene, const Motion& motion) {
  return *std::find_if(scene.components.begin(), scene.components.end(),
                       [&](const Component& component) { return component.name == motion.component; });
}

}  // namespace

MovingGeometry::MovingGeometry(ros::NodeHandle node, const MovingGeometryParameters& parameters)
    : scene_(loadMotions(parameters.scene)),
      player_(longest(scene_), parameters.speed, parameters.loop),
      components_(node, scene_, movingComponents(scene_)),
      play_server_(node.advertiseService(kPlayService, &MovingGeometry::play, this)),
      seek_server_(node.advertiseService(kSeekService, &MovingGeometry::seek, this)) {
  std::set<std::string> riding = movingComponents(scene_);
  for (const Motion& motion : scene_.motions) riding.erase(motion.component);
  std::vector<geometry_msgs::TransformStamped> transforms;
  for (const Component& component : scene_.components) {
    if (riding.count(component.name) == 0) continue;
    transforms.push_back(toTransform(component.pose, component.parent, component.name, ros::Time::now()));
  }
  if (!transforms.empty()) static_broadcaster_.sendTransform(transforms);
  timer_ = node.createTimer(ros::Duration(1.0 / parameters.rate_hz), &MovingGeometry::tick, this);
}

void MovingGeometry::tick(const ros::TimerEvent&) {
  const ros::Time now = ros::Time::now();
  if (!last_.isZero()) player_.advance((now - last_).toSec());
  last_ = now;
  sendTransforms();
}

void MovingGeometry::sendTransforms() {
  std::vector<geometry_msgs::TransformStamped> transforms;
  for (const Motion& motion : scene_.motions) {
    transforms.push_back(toTransform(poseAt(motion, player_.time()), componentOf(scene_, motion).parent,
                                     motion.component, last_));
  }
  broadcaster_.sendTransform(transforms);
}

bool MovingGeometry::play(std_srvs::SetBoolRequest& request, std_srvs::SetBoolResponse& response) {
  response.success = !scene_.motions.empty();
  if (response.success) {
    player_.play(request.data);
  } else {
    response.message = "scene '" + scene_.source + "' has no motions";
  }
  return true;
}

bool MovingGeometry::seek(cable_variation::SeekRequest& request, cable_variation::SeekResponse& response) {
  response.status = runRequest([&] { player_.seek(request.time); });
  return true;
}

}  // namespace cable_variation_ros
