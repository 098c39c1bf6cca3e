#include <ros_interface/markers/label_placing.h>

#include <cmath>

#include <visualization_msgs/Marker.h>

namespace cable_variation_ros {

namespace {

constexpr double kLetterWidth = 0.6;  // of the height, on average in RViz's font
constexpr double kLineSpacing = 1.4;  // of the height

}  // namespace

LabelPlacing::Label LabelPlacing::labelOf(const Eigen::Vector3d& centre, const std::string& text,
                                          double height) {
  return {centre, kLetterWidth * height * static_cast<double>(text.size()), height};
}

void LabelPlacing::keep(const visualization_msgs::MarkerArray& others) {
  for (const visualization_msgs::Marker& marker : others.markers) {
    if (marker.type != visualization_msgs::Marker::TEXT_VIEW_FACING ||
        marker.action != visualization_msgs::Marker::ADD) {
      continue;
    }
    const auto& at = marker.pose.position;
    labels_.push_back(labelOf({at.x, at.y, at.z}, marker.text, marker.scale.z));
  }
}

Eigen::Vector3d LabelPlacing::place(const Eigen::Vector3d& wanted, const std::string& text, double height) {
  Label label = labelOf(wanted, text, height);
  bool moved = true;
  while (moved) {
    moved = false;
    for (const Label& other : labels_) {
      const double aside = (label.centre - other.centre).head<2>().norm();
      const double least = 0.5 * kLineSpacing * (label.height + other.height);
      if (aside >= 0.5 * (label.width + other.width) ||
          std::abs(label.centre.z() - other.centre.z()) >= (1.0 - 1e-9) * least) {
        continue;
      }
      label.centre.z() = other.centre.z() + least;
      moved = true;
    }
  }
  labels_.push_back(label);
  return label.centre;
}

}  // namespace cable_variation_ros
