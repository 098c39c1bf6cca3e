#pragma once

#include <string>
#include <vector>

#include <Eigen/Core>
#include <visualization_msgs/MarkerArray.h>

namespace cable_variation_ros {

/// Finds places for texts so that none hides another: those too close to one placed before go up a line.
/// Seen from above, texts that are apart along the line of sight may still cover each other.
class LabelPlacing {
 public:
  /// The texts in `others` keep their places.
  void keep(const visualization_msgs::MarkerArray& others);

  /// The centre of `text` with letters of `height` [m]: `wanted`, or as little above it (along z) as leaves
  /// all texts placed before readable. The place is then taken.
  Eigen::Vector3d place(const Eigen::Vector3d& wanted, const std::string& text, double height);

 private:
  struct Label {
    Eigen::Vector3d centre;
    double width, height;
  };
  static Label labelOf(const Eigen::Vector3d& centre, const std::string& text, double height);

  std::vector<Label> labels_;
};

}  // namespace cable_variation_ros
