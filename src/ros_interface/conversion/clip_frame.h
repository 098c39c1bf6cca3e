#pragma once

#include <string>

#include <cable_variation/scene/scene.h>

namespace cable_variation_ros {

/// The tf frame of a clip: its name, or clip/NAME where a component has that name, the world or the scene.
std::string clipFrame(const cable_variation::Scene& scene, const std::string& clip);

}  // namespace cable_variation_ros
