#pragma once

#include <set>
#include <string>
#include <vector>

#include <cable_variation/scene/scene.h>

namespace cable_variation {

/// Components that have a motion, and those that ride on one of them.
std::set<std::string> movingComponents(const Scene& scene);

/// World poses, at `time` [s], of the components that `motions` move; each motion is
/// clamped to its recording. Throws std::invalid_argument if one is not loaded.
ComponentPoses posesDuring(const Scene& scene, const std::vector<const Motion*>& motions, double time);

/// Of a component among `poses`, of "world" none. Throws std::out_of_range for one that is not there.
Pose poseIn(const ComponentPoses& poses, const std::string& component);

}  // namespace cable_variation
