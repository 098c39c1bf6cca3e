#include <ros_interface/markers/marker_colours.h>

#include <array>

namespace cable_variation_ros {

Eigen::Vector4d cableColour(std::size_t index) {
  static const std::array<Eigen::Vector4d, 6> colours = {
      Eigen::Vector4d(0.95, 0.52, 0.08, 1.0), Eigen::Vector4d(0.98, 0.80, 0.20, 1.0),
      Eigen::Vector4d(0.16, 0.56, 0.92, 1.0), Eigen::Vector4d(0.25, 0.75, 0.42, 1.0),
      Eigen::Vector4d(0.68, 0.45, 0.90, 1.0), Eigen::Vector4d(0.20, 0.78, 0.80, 1.0)};
  return colours[index % colours.size()];
}

}  // namespace cable_variation_ros
