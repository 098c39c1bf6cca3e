#pragma once

#include <Eigen/Core>
#include <std_msgs/ColorRGBA.h>

namespace cable_variation_ros {

/// The colour map viridis (van der Walt and Smith 2015): 0 dark violet, 1 yellow, readable with every colour
/// vision and in grey. Each of r g b is within 0.004 of the published table.
/// @param share limited to [0, 1]; not a number is grey, which viridis does not contain
Eigen::Vector3d viridis(double share);

/// Colours for values between two bounds; of equal bounds all values take the lower one's colour.
class ColourScale {
 public:
  /// Throws std::invalid_argument unless both are finite and in order.
  ColourScale(double minimum, double maximum);

  double minimum() const { return minimum_; }
  double maximum() const { return maximum_; }

  Eigen::Vector3d operator()(double value) const;  ///< r g b
  std_msgs::ColorRGBA rgba(double value) const;    ///< opaque

 private:
  double minimum_;
  double maximum_;
};

}  // namespace cable_variation_ros
