#pragma once

#include <array>
#include <string>

#include <Eigen/Core>

#include <ros_interface/interaction/added_clip.h>

namespace cable_variation_ros {

/// A cable that could be added to a design, with the clips that hold its ends.
struct AddedCable {
  cable_variation::Cable cable;
  std::array<AddedClip, 2> ends;
};

/// A first guess, to be dragged where it belongs: a slack cable over a point of a component in the world,
/// along the component's longest horizontal side and about half as long, 4 mm thick and as soft as a taped
/// bundle, its ends fixed on the component. Names are such that no other has.
AddedCable cableAt(const SolverContext& context, const Eigen::Vector3d& point, const std::string& component);

}  // namespace cable_variation_ros
