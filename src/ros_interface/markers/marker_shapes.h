#pragma once

#include <array>
#include <string>
#include <vector>

#include <Eigen/Core>
#include <visualization_msgs/Marker.h>

#include <cable_variation/geometry/mesh/triangle_mesh.h>
#include <cable_variation/math/pose.h>

namespace cable_variation_ros {

/// What markers of one thing have in common; each one added gets the next id.
class MarkerGroup {
 public:
  MarkerGroup(const std::string& marker_namespace, const std::string& frame, const Eigen::Vector4d& color);

  void setColor(const Eigen::Vector4d& color) { color_ = color; }

  void addBox(const cable_variation::Pose& pose, const Eigen::Vector3d& size);              ///< edges [m]
  void addSphere(const Eigen::Vector3d& centre, double radius);                             ///< [m]
  void addCylinder(const Eigen::Vector3d& from, const Eigen::Vector3d& to, double radius);  ///< [m]
  /// With a head; nothing if there is no way between.
  void addArrow(const Eigen::Vector3d& from, const Eigen::Vector3d& to, double radius);  ///< of the shaft [m]
  void addMesh(const cable_variation::Pose& pose, const cable_variation::TriangleMesh& mesh);
  void addMeshResource(const cable_variation::Pose& pose, const std::string& address,
                       const Eigen::Vector3d& scale);
  /// Straight lines from each even point to the next one; none: the id is left out.
  void addLines(const std::vector<Eigen::Vector3d>& ends, double width);                ///< [m]
  void addText(const Eigen::Vector3d& centre, const std::string& text, double height);  ///< [m]

  const std::vector<visualization_msgs::Marker>& markers() const { return markers_; }

  /// Markers ride on their frame, wherever tf takes it.
  void lockToFrame();

 private:
  visualization_msgs::Marker& add(int type, const cable_variation::Pose& pose, const Eigen::Vector3d& scale);

  std::string namespace_;
  std::string frame_;
  Eigen::Vector4d color_;  ///< r g b a
  int next_id_ = 0;
  std::vector<visualization_msgs::Marker> markers_;
};

}  // namespace cable_variation_ros
