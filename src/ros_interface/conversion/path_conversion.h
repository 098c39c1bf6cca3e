#pragma once

#include <cable_variation/CheckPath.h>

#include <cable_variation/path/path_check.h>

namespace cable_variation_ros {

/// All but the status, files, warnings of the request and times that it took.
/// @param frame of each sample, world; none: several components move
cable_variation::CheckPathResponse toResponse(const cable_variation::Scene& scene,
                                              const cable_variation::PathCheck& check,
                                              const cable_variation::ComponentPath& path);

}  // namespace cable_variation_ros
