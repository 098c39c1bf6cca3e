#pragma once

#include <string>

#include <Eigen/Core>

#include <cable_variation/scene/scene.h>

namespace cable_variation_ros {

class SolverContext;

/// A clip that could be added to a design, and where it is mounted.
struct AddedClip {
  cable_variation::Clip clip;
  cable_variation::ClipMount mount;
};

/// A clip of the preset `type` that holds a cable as it is now, at its place next to a point in the world,
/// and has a name that no other has. Throws as requireConverged() while there is no shape.
/// @param cable empty: the closest one
/// @param component empty: the one whose surface is closest to that place, world if none has one
AddedClip clipAt(const SolverContext& context, const Eigen::Vector3d& point, const std::string& type,
                 const std::string& cable, const std::string& component);

}  // namespace cable_variation_ros
