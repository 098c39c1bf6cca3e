#pragma once

#include <vector>

#include <visualization_msgs/MarkerArray.h>

#include <cable_variation/Label.h>

#include <cable_variation/path/path_check.h>

namespace cable_variation_ros {

/// What was found along a path: centrelines at some forty times, dark at its start to yellow at its end
/// (namespace path/CABLE), the way of the frame that went along it (path/way), and what happened, with when
/// and where (path/events): red what must not be.
visualization_msgs::MarkerArray pathMarkers(const cable_variation::Scene& scene,
                                            const cable_variation::PathCheck& check,
                                            const cable_variation::ComponentPath& path);

/// What happened, at its place; faults are those that nobody wants.
std::vector<cable_variation::Label> pathLabels(const cable_variation::Scene& scene,
                                               const cable_variation::PathCheck& check);

}  // namespace cable_variation_ros
