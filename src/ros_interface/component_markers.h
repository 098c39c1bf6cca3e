#pragma once

#include <set>
#include <string>

#include <visualization_msgs/MarkerArray.h>

#include <cable_variation/scene/scene.h>

namespace cable_variation_ros {

/// The components' visible pieces, each in its component's frame, in namespace
/// component/NAME; only components in `which`.
visualization_msgs::MarkerArray componentMarkers(const cable_variation::Scene& scene,
                                                 const std::set<std::string>& which);

}  // namespace cable_variation_ros
