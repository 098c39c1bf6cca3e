#pragma once

#include <string>

#include <cable_variation/scene/motion.h>

namespace cable_variation_ros {

/// What readBagMotion() says, by rosbag in this process, which need not survive it: rosbag believes what a
/// file says of itself. In the program bag_importer alone.
void readBagHere(const std::string& path, const std::string& topic, const std::string& frame,
                 const std::string& parent, cable_variation::Motion& motion);

}  // namespace cable_variation_ros
