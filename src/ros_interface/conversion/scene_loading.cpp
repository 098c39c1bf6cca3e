#include <ros_interface/conversion/scene_loading.h>

#include <filesystem>

#include <ros/console.h>
#include <ros/package.h>

#include <cable_variation/scene/motion_samples.h>
#include <cable_variation/scene/resource_address.h>
#include <cable_variation/scene_file/plausibility.h>
#include <cable_variation/scene_file/scene_reader.h>
#include <cable_variation/util/error.h>
#include <ros_interface/conversion/bag_motion.h>

namespace cable_variation_ros {

using cable_variation::Component;
using cable_variation::Motion;
using cable_variation::Scene;
using cable_variation::SceneError;
using cable_variation::SceneFault;

namespace {

std::string parentOf(const Scene& scene, const std::string& name) {
  for (const Component& component : scene.components) {
    if (component.name == name) return component.parent;
  }
  throw std::invalid_argument("no component named '" + name + "'");
}

}  // namespace

std::string findPackage(const std::string& package) { return ros::package::getPath(package); }

std::string resolveAddress(const std::string& address, std::uintmax_t most_bytes,
                           const std::vector<std::string>& folders) {
  if (address.find("://") != std::string::npos) {
    try {
      return cable_variation::localPath(address, findPackage, most_bytes, folders);
    } catch (const std::invalid_argument& error) {
      throw cable_variation::NotFound(error.what());
    }
  }
  try {
    cable_variation::requireWithin(address, folders);
  } catch (const std::invalid_argument& error) {
    throw cable_variation::NotFound(error.what());
  }
  const std::string obstacle = cable_variation::obstacleTo(address, most_bytes);
  if (!obstacle.empty()) {
    std::error_code ignored;
    const std::filesystem::path where = std::filesystem::absolute(address, ignored);
    throw cable_variation::NotFound("'" + where.string() + "' " + obstacle);
  }
  return address;
}

Scene loadScene(const std::string& address, const cable_variation::InputLimits& limits) {
  std::string path;
  try {
    path = resolveAddress(address, limits.scene_bytes, limits.folders);
  } catch (const cable_variation::NotFound& error) {
    throw cable_variation::NotFound("scene '" + address + "': " + error.what());
  }
  Scene scene = cable_variation::readScene(path, findPackage, limits);
  std::vector<SceneFault> faults;
  for (Motion& motion : scene.motions) {
    if (!cable_variation::isBag(motion.file)) continue;
    const std::string who = "motion '" + motion.name + "': ";
    try {
      readBagMotion(motion.path, motion.topic, motion.frame, parentOf(scene, motion.component), motion);
    } catch (const std::exception& error) {
      faults.push_back({path, motion.line, who + error.what()});
      continue;
    }
    for (const std::string& remark :
         {cable_variation::noteOnReplaced(motion), cable_variation::slipOf(motion, scene)}) {
      if (!remark.empty()) scene.warnings.push_back({path, motion.line, who + remark});
    }
  }
  if (!faults.empty()) throw SceneError(faults);
  return scene;
}

std::vector<std::string> warningsOf(const Scene& scene) {
  std::vector<std::string> texts;
  for (const SceneFault& warning : scene.warnings) texts.push_back(toString(warning));
  return texts;
}

void logWarnings(const Scene& scene) {
  for (const std::string& warning : warningsOf(scene)) ROS_WARN("%s", warning.c_str());
}

}  // namespace cable_variation_ros
