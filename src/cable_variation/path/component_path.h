#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include <cable_variation/scene/design.h>

namespace cable_variation {

/// Where components go, by a time, and where they would be without that.
struct ComponentPath {
  std::vector<double> times;  ///< of the poses that it was given, rising [s]; straight between two of them
  bool every_pose = false;    ///< all of those are to be looked at, however close they are
  /// Components that are not where the scene has them, world, as harnessAt() takes them.
  std::function<ComponentPoses(double time)> places;
  /// The frame that was asked to go along it, world; none: several components move.
  std::function<Pose(double time)> frame;
};

/// A component goes through `poses` [world], straight from one to the next and turning the shortest way; what
/// rides on it comes along. Its frame takes them as it is in the design, deviations and edits included.
/// @param moved components in force that are not where the scene has them, placesOf()
/// Throws std::invalid_argument: no such component, fewer than two poses, times that do not rise.
ComponentPath pathOfComponent(const Design& design, const ComponentPoses& moved, const std::string& component,
                              const std::vector<TimedPose>& poses);

/// Likewise, but a clip's frame takes the poses and its component goes with it. Throws as well for a clip
/// whose component is "world".
/// @param harness of the design, with its clips where they are now
ComponentPath pathOfClip(const Design& design, const ComponentPoses& moved, const Harness& harness,
                         const std::string& clip, const std::vector<TimedPose>& poses);

/// Recorded motions (indices into Scene::motions, of one component each) from `from` to `to` [s].
/// @param on_tf components that tf has elsewhere; those that the motions move are where the motions say
/// Throws std::invalid_argument: a motion is not loaded.
ComponentPath pathOfMotions(const Design& design, const ComponentPoses& on_tf,
                            const std::vector<std::size_t>& motions, double from, double to);

}  // namespace cable_variation
