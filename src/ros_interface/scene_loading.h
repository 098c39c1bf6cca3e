#pragma once

#include <string>

#include <cable_variation/scene/scene.h>

namespace cable_variation_ros {

/// The folder of a ROS package; empty: not found.
std::string findPackage(const std::string& package);

/// The file that a path, a file:// or a package:// address names. Throws
/// RequestError (NOT_FOUND) for an unknown package or an address of another kind.
std::string resolveAddress(const std::string& address);

/// Reads a scene and the bags its motions are recorded in. Throws RequestError
/// (NOT_FOUND) if there is no such file and SceneError for what is wrong with it.
cable_variation::Scene loadScene(const std::string& address);

}  // namespace cable_variation_ros
