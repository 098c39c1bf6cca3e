#pragma once

#include <string>
#include <vector>

#include <cable_variation/scene/scene.h>
#include <ros_interface/context/solver_context.h>

namespace cable_variation_ros {

/// The design and the places of components that what is shown belongs to.
struct ViewOrigin {
  std::size_t design_number = 0;          ///< SolverContext::designNumber()
  cable_variation::ComponentPoses moved;  ///< where components were, without those in `carried`
  std::vector<std::string> carried;  ///< components that may move: what is shown holds for all their poses

  /// Whether it belongs to what is in force.
  bool fits(const SolverContext& context) const;
};

/// @param motions played, indices: they carry their components
ViewOrigin viewOrigin(const SolverContext::Snapshot& snapshot, const std::vector<std::size_t>& motions);

/// A warning for each component that is not where the scene has it, unless `motions` carry it: over a motion
/// it is taken to be there. None at rest.
std::vector<std::string> warningsOfMoved(const ViewOrigin& origin, const std::vector<std::size_t>& motions);

}  // namespace cable_variation_ros
