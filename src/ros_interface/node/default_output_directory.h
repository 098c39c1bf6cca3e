#pragma once

#include <string>

namespace cable_variation_ros {

/// cable_variation below ROS's own folder for what running nodes write: $ROS_HOME,
/// else ~/.ros, else the working directory.
std::string defaultOutputDirectory();

}  // namespace cable_variation_ros
