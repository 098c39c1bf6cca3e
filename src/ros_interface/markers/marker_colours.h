#pragma once

#include <Eigen/Core>

namespace cable_variation_ros {

/// Nothing else is red. r g b a
inline const Eigen::Vector4d kInterferenceRed(0.93, 0.10, 0.12, 1.0);

/// Of cables as they were when there last was an equilibrium. r g b a
inline const Eigen::Vector4d kOutdatedGrey(0.62, 0.62, 0.64, 0.45);

/// Of the cable with this index: readable on grey metal. r g b a
Eigen::Vector4d cableColour(std::size_t index);

}  // namespace cable_variation_ros
