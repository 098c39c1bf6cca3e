#pragma once

#include <cable_variation/math/pose.h>

namespace cable_variation_ros {

/// What a person meant who dragged something from the pose `before` to `wanted`, both in the same frame. RViz
/// calculates in single precision: coordinates and turns in which the two differ by less than its rounding
/// stay as they were, the others change by whole micrometres and microradians.
cable_variation::Pose mousePose(const cable_variation::Pose& before, const cable_variation::Pose& wanted);

}  // namespace cable_variation_ros
