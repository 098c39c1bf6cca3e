#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include <cable_variation/scene/resource_address.h>
#include <cable_variation/scene/scene.h>
#include <cable_variation/util/input_limits.h>

namespace cable_variation {

/// The file that a path, a file:// or a package:// address names. Throws NotFound for an unknown package, an
/// address of another kind, a path out of `folders` (if there are any), and what is not a file of at most
/// `most_bytes` that can be read.
std::string resolveAddress(const std::string& address, const PackageFinder& find_package,
                           std::uintmax_t most_bytes, const std::vector<std::string>& folders);

/// Reads the poses of a frame from a topic of a bag, into the motion. Throws std::invalid_argument.
/// @param parent frame that they are expected in
using BagReader = std::function<void(const std::string& path, const std::string& topic,
                                     const std::string& frame, const std::string& parent, Motion& motion)>;

/// Reads a scene and the bags its motions are recorded in. Throws NotFound if there is no such file and
/// SceneError for what is wrong with it.
/// @param read_bag none: a motion in a bag is a fault
Scene loadScene(const std::string& address, const PackageFinder& find_package, const BagReader& read_bag,
                const InputLimits& limits = {});

/// Implausible values in the scene, each as "FILE:LINE: MESSAGE".
std::vector<std::string> warningsOf(const Scene& scene);

}  // namespace cable_variation
