#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <cable_variation/scene/scene.h>
#include <cable_variation/util/input_limits.h>

namespace cable_variation_ros {

/// The folder of a ROS package; empty: not found.
std::string findPackage(const std::string& package);

/// The file that a path, a file:// or a package:// address names. Throws
/// cable_variation::NotFound for an unknown package, an address of another kind, a path out of `folders` (if
/// there are any), and what is not a file of at most `most_bytes` that can be read.
std::string resolveAddress(const std::string& address, std::uintmax_t most_bytes,
                           const std::vector<std::string>& folders);

/// Reads a scene and the bags its motions are recorded in. Throws
/// cable_variation::NotFound if there is no such file and SceneError for what is wrong with it.
cable_variation::Scene loadScene(const std::string& address, const cable_variation::InputLimits& limits = {});

/// Implausible values in the scene, each as "FILE:LINE: MESSAGE".
std::vector<std::string> warningsOf(const cable_variation::Scene& scene);

/// Each of them as a warning in the log.
void logWarnings(const cable_variation::Scene& scene);

}  // namespace cable_variation_ros
