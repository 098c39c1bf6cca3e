#include <ros_interface/node/default_output_directory.h>

#include <cstdlib>
#include <filesystem>

namespace cable_variation_ros {

std::string defaultOutputDirectory() {
  const char* ros_home = std::getenv("ROS_HOME");
  const char* home = std::getenv("HOME");
  std::filesystem::path folder;
  if (ros_home != nullptr && *ros_home != '\0') {
    folder = ros_home;
  } else if (home != nullptr && *home != '\0') {
    folder = std::filesystem::path(home) / ".ros";
  }
  return folder / "cable_variation";
}

}  // namespace cable_variation_ros
