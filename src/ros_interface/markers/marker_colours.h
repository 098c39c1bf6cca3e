#pragma once

#include <Eigen/Core>

namespace cable_variation_ros {

/// Nothing else is red. r g b a
inline const Eigen::Vector4d kInterferenceRed(0.93, 0.10, 0.12, 1.0);

/// Of the cable with this index: readable on grey metal. r g b a
Eigen::Vector4d cableColour(std::size_t index);

}  // namespace cable_variation_ros
