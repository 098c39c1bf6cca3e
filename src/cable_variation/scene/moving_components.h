#pragma once

#include <set>
#include <string>
#include <vector>

#include <cable_variation/scene/scene.h>

namespace cable_variation {

/// Components that have a motion or that joint states drive, and those that ride on one of them.
std::set<std::string> movingComponents(const Scene& scene);

/// Whether something of the scene moves it: a motion, unless tf or joint states drive it; a joint that is not
/// fixed. Not what it rides on.
bool movesItself(const Scene& scene, const Component& component);

/// The component at this index and, of a robot's root, its links: what is one part to a measure.
std::vector<std::size_t> bodiesOf(const Scene& scene, std::size_t component);

/// Whether both are the same component, or of the same robot.
bool sameRobot(const Component& a, const Component& b);

/// Whether a clip (index) is on the component, or on any link of its robot.
bool ridesOn(const Scene& scene, std::size_t clip, const Component& component);

/// World poses, at `time` [s], of the components that `motions` move; each motion is
/// clamped to its recording. Throws std::invalid_argument if one is not loaded.
ComponentPoses posesDuring(const Scene& scene, const std::vector<const Motion*>& motions, double time);

/// Of a component among `poses`, of "world" none. Throws std::out_of_range for one that is not there.
Pose poseIn(const ComponentPoses& poses, const std::string& component);

}  // namespace cable_variation
