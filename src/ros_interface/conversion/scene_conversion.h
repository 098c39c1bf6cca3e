#pragma once

#include <cable_variation/GetScene.h>

#include <cable_variation/scene/design.h>

namespace cable_variation_ros {

/// Everything but the status: the scene as designed, its components and clips where
/// they are with `moved` in force.
cable_variation::GetSceneResponse toResponse(const cable_variation::Design& design,
                                             const cable_variation::ComponentPoses& moved);

/// `nominal` as in the scene.
cable_variation::DesignVariableInfo toInfo(const cable_variation::DesignVariable& variable,
                                           const cable_variation::Scene& scene);

/// Of some variables, indices, `nominal` as in `values` where they are there.
std::vector<cable_variation::DesignVariableInfo> toInfos(const cable_variation::Scene& scene,
                                                         const std::vector<std::size_t>& variables,
                                                         const cable_variation::DesignValues& values);

}  // namespace cable_variation_ros
