#include <ros_interface/scene_loading.h>

#include <filesystem>

#include <ros/package.h>

#include <cable_variation/Status.h>

#include <cable_variation/scene/scene_reader.h>
#include <ros_interface/bag_motion.h>
#include <ros_interface/request_status.h>

namespace cable_variation_ros {

using cable_variation::Component;
using cable_variation::Motion;
using cable_variation::Scene;
using cable_variation::SceneError;
using cable_variation::SceneFault;
using cable_variation::Status;

namespace {

bool startsWith(const std::string& text, const std::string& start) {
  return text.compare(0, start.size(), start) == 0;
}

bool isBag(const std::string& file) { return std::filesystem::path(file).extension() == ".bag"; }

std::string parentOf(const Scene& scene, const std::string& name) {
  for (const Component& component : scene.components) {
    if (component.name == name) return component.parent;
  }
  throw std::invalid_argument("no component named '" + name + "'");
}

}  // namespace

std::string findPackage(const std::string& package) { return ros::package::getPath(package); }

std::string resolveAddress(const std::string& address) {
  const std::string kPackage = "package://";
  const std::string kFile = "file://";
  if (startsWith(address, kPackage)) {
    const std::size_t slash = address.find('/', kPackage.size());
    const std::string package = address.substr(kPackage.size(), slash - kPackage.size());
    const std::string folder = findPackage(package);
    if (folder.empty()) {
      throw RequestError(Status::NOT_FOUND, "'" + address + "': no ROS package named '" + package + "'");
    }
    return slash == std::string::npos ? folder : folder + address.substr(slash);
  }
  if (startsWith(address, kFile)) return address.substr(kFile.size());
  if (address.find("://") != std::string::npos) {
    throw RequestError(Status::NOT_FOUND, "'" + address + "': expected a path, file:// or package://");
  }
  return address;
}

Scene loadScene(const std::string& address) {
  const std::string path = resolveAddress(address);
  std::error_code ignored;
  if (!std::filesystem::is_regular_file(path, ignored)) {
    const std::filesystem::path where = std::filesystem::absolute(path, ignored);
    throw RequestError(Status::NOT_FOUND, "scene '" + address + "': no file '" + where.string() + "'");
  }
  Scene scene = cable_variation::readScene(path, findPackage);
  std::vector<SceneFault> faults;
  for (Motion& motion : scene.motions) {
    if (!motion.samples.empty() || !isBag(motion.path)) continue;
    try {
      motion.samples =
          readBagMotion(motion.path, motion.topic, motion.frame, parentOf(scene, motion.component));
    } catch (const std::exception& error) {
      faults.push_back({path, 0, "motion '" + motion.name + "': " + error.what()});
    }
  }
  if (!faults.empty()) throw SceneError(faults);
  return scene;
}

}  // namespace cable_variation_ros
