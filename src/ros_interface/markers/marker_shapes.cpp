#include <ros_interface/markers/marker_shapes.h>

#include <algorithm>

#include <ros_interface/conversion/message_conversion.h>

namespace cable_variation_ros {

using cable_variation::Pose;
using visualization_msgs::Marker;

MarkerGroup::MarkerGroup(const std::string& marker_namespace, const std::string& frame,
                         const Eigen::Vector4d& color)
    : namespace_(marker_namespace), frame_(frame), color_(color) {}

Marker& MarkerGroup::add(int type, const Pose& pose, const Eigen::Vector3d& scale) {
  Marker marker;
  marker.header.frame_id = frame_;
  marker.ns = namespace_;
  marker.id = next_id_++;
  marker.type = type;
  marker.action = Marker::ADD;
  marker.pose = toPose(pose);
  marker.scale = toVector(scale);
  marker.color.r = static_cast<float>(color_[0]);
  marker.color.g = static_cast<float>(color_[1]);
  marker.color.b = static_cast<float>(color_[2]);
  marker.color.a = static_cast<float>(color_[3]);
  markers_.push_back(marker);
  return markers_.back();
}

void MarkerGroup::addBox(const Pose& pose, const Eigen::Vector3d& size) { add(Marker::CUBE, pose, size); }

void MarkerGroup::addSphere(const Eigen::Vector3d& centre, double radius) {
  Pose pose;
  pose.position = centre;
  add(Marker::SPHERE, pose, Eigen::Vector3d::Constant(2.0 * radius));
}

void MarkerGroup::addCylinder(const Eigen::Vector3d& from, const Eigen::Vector3d& to, double radius) {
  Pose pose;
  pose.position = 0.5 * (from + to);
  pose.orientation = Eigen::Quaterniond::FromTwoVectors(Eigen::Vector3d::UnitZ(), to - from);
  add(Marker::CYLINDER, pose, {2.0 * radius, 2.0 * radius, (to - from).norm()});
}

void MarkerGroup::addArrow(const Eigen::Vector3d& from, const Eigen::Vector3d& to, double radius) {
  const double length = (to - from).norm();
  if (!(length > 0.0)) return;
  const double head = std::min(6.0 * radius, 0.5 * length);
  Marker& marker = add(Marker::ARROW, Pose(), {2.0 * radius, 4.5 * radius, head});
  marker.points = {toPoint(from), toPoint(to)};
}

void MarkerGroup::addMesh(const Pose& pose, const cable_variation::TriangleMesh& mesh) {
  Marker& marker = add(Marker::TRIANGLE_LIST, pose, Eigen::Vector3d::Ones());
  marker.points.reserve(3 * mesh.triangles.size());
  for (const auto& triangle : mesh.triangles) {
    for (const std::uint32_t vertex : triangle) marker.points.push_back(toPoint(mesh.vertices[vertex]));
  }
}

void MarkerGroup::addMeshResource(const Pose& pose, const std::string& address,
                                  const Eigen::Vector3d& scale) {
  add(Marker::MESH_RESOURCE, pose, scale).mesh_resource = address;
}

void MarkerGroup::addLines(const std::vector<Eigen::Vector3d>& ends, double width) {
  if (ends.empty()) {
    ++next_id_;
    return;
  }
  Marker& marker = add(Marker::LINE_LIST, Pose(), {width, 0.0, 0.0});
  marker.points.reserve(ends.size());
  for (const Eigen::Vector3d& end : ends) marker.points.push_back(toPoint(end));
}

void MarkerGroup::addText(const Eigen::Vector3d& centre, const std::string& text, double height) {
  Pose pose;
  pose.position = centre;
  add(Marker::TEXT_VIEW_FACING, pose, {0.0, 0.0, height}).text = text;
}

void MarkerGroup::lockToFrame() {
  for (Marker& marker : markers_) marker.frame_locked = true;
}

}  // namespace cable_variation_ros
