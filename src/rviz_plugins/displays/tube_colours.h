#pragma once

#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

#include <cable_variation/CableTubes.h>

#include <rviz_plugins/colour_maps.h>

namespace cable_variation_rviz {

/// What cables are coloured by.
struct TubeColouring {
  std::string quantity;  ///< cables without it have their own colour, and those that are elsewhere none
  double minimum = 0.0;
  double maximum = 0.0;
  ColourMap map = ColourMap::viridis;
  float alpha = 1.0F;
};

/// Range and unit of a quantity, over all cables that have it; none: no cable has.
struct QuantityRange {
  double minimum = 0.0;
  double maximum = 0.0;
  std::string unit;
};
std::optional<QuantityRange> rangeOf(const cable_variation::CableTubes& tubes, const std::string& quantity);

/// Names of all quantities in the message, each once, in order.
std::vector<std::string> quantitiesOf(const cable_variation::CableTubes& tubes);

/// r g b a of each station of a cable; empty: it is not to be drawn. Outdated cables are grey.
/// @param index of the cable in the message
std::vector<Eigen::Vector4f> stationColours(const cable_variation::CableTubes& tubes, std::size_t index,
                                            const TubeColouring& colouring);

}  // namespace cable_variation_rviz
