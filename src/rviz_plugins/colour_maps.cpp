#include <rviz_plugins/colour_maps.h>

#include <algorithm>
#include <cmath>

#include <ros_interface/markers/colour_map.h>

namespace cable_variation_rviz {

namespace {

const Eigen::Vector3d kNoNumber(0.55, 0.25, 0.65);  // where colours are grey

}  // namespace

Eigen::Vector3d mapped(ColourMap map, double share) {
  switch (map) {
    case ColourMap::viridis:
      return cable_variation_ros::viridis(share);
    case ColourMap::viridis_reversed:
      return cable_variation_ros::viridis(1.0 - share);
    case ColourMap::grey:
      break;
  }
  if (std::isnan(share)) return kNoNumber;
  return Eigen::Vector3d::Constant(0.1 + 0.85 * std::clamp(share, 0.0, 1.0));
}

Eigen::Vector3d mapped(ColourMap map, double value, double minimum, double maximum) {
  if (std::isnan(value)) return mapped(map, value);
  return mapped(map, maximum > minimum ? (value - minimum) / (maximum - minimum) : 0.0);
}

}  // namespace cable_variation_rviz
