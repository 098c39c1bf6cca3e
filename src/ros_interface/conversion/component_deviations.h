#pragma once

#include <cable_variation/ComponentDeviations.h>

#include <cable_variation/scene/scene.h>

namespace cable_variation_ros {

/// What design variables at `values`, and edits, do to components: the pose of each that they move, in its
/// frame as `on_tf` and the scene have it. @param moved placesOf() the design
cable_variation::ComponentPoses componentDeviations(const cable_variation::Scene& scene,
                                                    const cable_variation::DesignValues& values,
                                                    const cable_variation::ComponentPoses& moved,
                                                    const cable_variation::ComponentPoses& on_tf);

cable_variation::ComponentDeviations toMessage(const cable_variation::ComponentPoses& deviations);

/// Throws std::invalid_argument that names the component, as fromPose().
cable_variation::ComponentPoses fromMessage(const cable_variation::ComponentDeviations& message);

}  // namespace cable_variation_ros
