#pragma once

#include <string>

namespace cable_variation {

/// The folder of a package without ROS at hand: its package.xml is looked for below the folders of the
/// environment's ROS_PACKAGE_PATH, as rospack does, then in the folders around `near` and in share/ of the
/// prefix that the running program is installed to. Empty: not found.
/// @param near a file or folder, such as the scene that names the package; need not exist
std::string findPackageNear(const std::string& package, const std::string& near);

}  // namespace cable_variation
