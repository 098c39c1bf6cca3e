#include <ros_interface/markers/coloured_mesh.h>

#include <array>
#include <cmath>

#include <std_msgs/ColorRGBA.h>

#include <ros_interface/conversion/message_conversion.h>

namespace cable_variation_ros {

using cable_variation::TriangleMesh;
using Eigen::Vector3d;

namespace {

const double kCreaseCosine = std::cos(35.0 * M_PI / 180.0);       // faces at a larger angle meet in an edge
const Vector3d kLight = Vector3d(0.45, 0.25, 0.85).normalized();  // towards it, world
constexpr double kDarkest = 0.66;

/// Per triangle and corner the normal of the smooth surface it belongs to.
std::vector<std::array<Vector3d, 3>> cornerNormals(const TriangleMesh& mesh) {
  const std::size_t count = mesh.triangles.size();
  std::vector<Vector3d> weighted(count), normals(count, Vector3d::Zero());
  std::vector<std::vector<std::uint32_t>> around(mesh.vertices.size());
  for (std::size_t i = 0; i < count; ++i) {
    const auto& t = mesh.triangles[i];
    const Vector3d& a = mesh.vertices[t[0]];
    weighted[i] = (mesh.vertices[t[1]] - a).cross(mesh.vertices[t[2]] - a);  // by area
    const double length = weighted[i].norm();
    if (length > 0.0) normals[i] = weighted[i] / length;
    for (const std::uint32_t vertex : t) around[vertex].push_back(static_cast<std::uint32_t>(i));
  }
  std::vector<std::array<Vector3d, 3>> corners(count);
  for (std::size_t i = 0; i < count; ++i) {
    for (std::size_t k = 0; k < 3; ++k) {
      Vector3d sum = Vector3d::Zero();
      for (const std::uint32_t other : around[mesh.triangles[i][k]]) {
        if (normals[i].dot(normals[other]) >= kCreaseCosine) sum += weighted[other];
      }
      const double length = sum.norm();
      corners[i][k] = length > 0.0 ? Vector3d(sum / length) : normals[i];
    }
  }
  return corners;
}

}  // namespace

void addColouredMesh(const TriangleMesh& mesh, const cable_variation::Pose& pose,
                     const Eigen::Quaterniond& orientation, const std::vector<Vector3d>& colors, double lift,
                     visualization_msgs::Marker& marker) {
  const std::vector<std::array<Vector3d, 3>> normals = cornerNormals(mesh);
  const Vector3d light = orientation.conjugate() * kLight;
  marker.points.reserve(marker.points.size() + 3 * mesh.triangles.size());
  marker.colors.reserve(marker.colors.size() + 3 * mesh.triangles.size());
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t vertex = mesh.triangles[i][k];
      const Vector3d& normal = normals[i][k];
      marker.points.push_back(toPoint(pose * (mesh.vertices[vertex] + lift * normal)));
      const double brightness = kDarkest + (1.0 - kDarkest) * (0.5 + 0.5 * normal.dot(light));
      const Eigen::Vector3f color = (brightness * colors.at(vertex)).cast<float>();
      std_msgs::ColorRGBA rgba;
      rgba.r = color[0];
      rgba.g = color[1];
      rgba.b = color[2];
      rgba.a = 1.0F;
      marker.colors.push_back(rgba);
    }
  }
}

}  // namespace cable_variation_ros
