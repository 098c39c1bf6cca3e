#pragma once

#include <cable_variation/scene/scene.h>

namespace cable_variation_ros {

/// Whether two poses are the same but for what a transform loses on its way through tf: 1e-9 m and rad.
bool same(const cable_variation::Pose& a, const cable_variation::Pose& b);

/// Whether the same components are at the same poses.
bool same(const cable_variation::ComponentPoses& a, const cable_variation::ComponentPoses& b);

}  // namespace cable_variation_ros
