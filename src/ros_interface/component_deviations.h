#pragma once

#include <cable_variation/ComponentDeviations.h>

#include <cable_variation/scene/design.h>

namespace cable_variation_ros {

/// What the design does to components: the pose of each that it moves, in its frame
/// as `moved` and the scene have it.
cable_variation::ComponentPoses componentDeviations(const cable_variation::Design& design,
                                                    const cable_variation::ComponentPoses& moved);

cable_variation::ComponentDeviations toMessage(const cable_variation::ComponentPoses& deviations);

/// Throws std::invalid_argument that names the component, as fromPose().
cable_variation::ComponentPoses fromMessage(const cable_variation::ComponentDeviations& message);

}  // namespace cable_variation_ros
