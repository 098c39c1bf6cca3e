#pragma once

#include <set>
#include <string>

#include <visualization_msgs/MarkerArray.h>

#include <cable_variation/scene/scene.h>

namespace cable_variation_ros {

/// The components' visible pieces, each in its component's frame, in namespace
/// component/NAME; only components in `which`. Those in `deviations` are at this pose
/// in their frame instead of its origin.
visualization_msgs::MarkerArray componentMarkers(const cable_variation::Scene& scene,
                                                 const std::set<std::string>& which,
                                                 const cable_variation::ComponentPoses& deviations);

}  // namespace cable_variation_ros
