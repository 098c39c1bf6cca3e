#pragma once

#include <Eigen/Core>

namespace cable_variation_rviz {

enum class ColourMap { viridis, viridis_reversed, grey };

/// r g b. Not a number is grey, in the map `grey` violet.
/// @param share of the range, limited to [0, 1]
Eigen::Vector3d mapped(ColourMap map, double share);

/// The same of a value in a range; of an empty range all values take the lower bound's colour.
Eigen::Vector3d mapped(ColourMap map, double value, double minimum, double maximum);

}  // namespace cable_variation_rviz
