#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <cable_variation/analysis/scene_loading.h>

namespace cable_variation_ros {

/// The folder of a ROS package; empty: not found.
std::string findPackage(const std::string& package);

/// As cable_variation::resolveAddress(), packages being those that ROS knows.
std::string resolveAddress(const std::string& address, std::uintmax_t most_bytes,
                           const std::vector<std::string>& folders);

/// As cable_variation::loadScene(), likewise, with motions in bags.
cable_variation::Scene loadScene(const std::string& address, const cable_variation::InputLimits& limits = {});

/// Implausible values in the scene, each as a warning in the log.
void logWarnings(const cable_variation::Scene& scene);

}  // namespace cable_variation_ros
