#include <ros_interface/conversion/scene_loading.h>

#include <ros/console.h>
#include <ros/package.h>

#include <ros_interface/conversion/bag_motion.h>

namespace cable_variation_ros {

std::string findPackage(const std::string& package) { return ros::package::getPath(package); }

std::string resolveAddress(const std::string& address, std::uintmax_t most_bytes,
                           const std::vector<std::string>& folders) {
  return cable_variation::resolveAddress(address, findPackage, most_bytes, folders);
}

cable_variation::Scene loadScene(const std::string& address, const cable_variation::InputLimits& limits) {
  const auto read_bag = [&limits](const std::string& path, const std::string& topic, const std::string& frame,
                                  const std::string& parent, cable_variation::Motion& motion) {
    readBagMotion(path, topic, frame, parent, motion, limits);
  };
  return cable_variation::loadScene(address, findPackage, read_bag, limits);
}

void logWarnings(const cable_variation::Scene& scene) {
  for (const std::string& warning : warningsOf(scene)) ROS_WARN("%s", warning.c_str());
}

}  // namespace cable_variation_ros
