#include <rviz_plugins/displays/message_checks.h>

#include <algorithm>
#include <cmath>

namespace cable_variation_rviz {

using cable_variation::CableQuantity;
using cable_variation::CableTube;

namespace {

constexpr double kFarthest = 1e9;  // [m]

bool near(double coordinate) { return std::abs(coordinate) <= kFarthest; }  // false for what is no number
bool near(const geometry_msgs::Point& point) { return near(point.x) && near(point.y) && near(point.z); }

std::string faultOf(const CableTube& tube) {
  const std::size_t count = tube.radius.size();
  const std::string named = "cable '" + tube.cable + "': ";
  if (tube.position.size() != 3 * count) {
    return named + std::to_string(tube.position.size()) + " coordinates for " + std::to_string(count) +
           " stations";
  }
  if (!std::all_of(tube.position.begin(), tube.position.end(), [](float value) { return near(value); })) {
    return named + "a position is not finite";
  }
  if (!std::all_of(tube.radius.begin(), tube.radius.end(),
                   [](float value) { return near(value) && value >= 0.0F; })) {
    return named + "a radius is not finite or negative";
  }
  for (const CableQuantity& quantity : tube.quantities) {
    if (quantity.values.size() != count) {
      return named + std::to_string(quantity.values.size()) + " values of " + quantity.name + " for " +
             std::to_string(count) + " stations";
    }
    if (!std::isfinite(quantity.minimum) || !std::isfinite(quantity.maximum) ||
        quantity.minimum > quantity.maximum) {
      return named + "the bounds of " + quantity.name + " are not finite or not in order";
    }
  }
  return "";
}

}  // namespace

std::string faultOf(const cable_variation::CableTubes& tubes) {
  if (!near(tubes.origin)) return "the origin is not finite";
  for (const CableTube& tube : tubes.cables) {
    std::string fault = faultOf(tube);
    if (!fault.empty()) return fault;
  }
  return "";
}

std::string faultOf(const cable_variation::EnvelopeMesh& envelope) {
  const auto& vertices = envelope.mesh.vertices;
  for (const geometry_msgs::Point& vertex : vertices) {
    if (!near(vertex)) return "a vertex is not finite";
  }
  for (const shape_msgs::MeshTriangle& triangle : envelope.mesh.triangles) {
    for (const std::uint32_t vertex : triangle.vertex_indices) {
      if (vertex >= vertices.size()) {
        return "a triangle has vertex " + std::to_string(vertex) + " of " + std::to_string(vertices.size());
      }
    }
  }
  return "";
}

std::string faultOf(const cable_variation::Labels& labels) {
  for (const cable_variation::Label& label : labels.labels) {
    if (!near(label.at)) return "the place of '" + label.text + "' is not finite";
  }
  return "";
}

}  // namespace cable_variation_rviz
