#include <ros_interface/markers/envelope_markers.h>

#include <map>

#include <ros_interface/conversion/message_conversion.h>
#include <ros_interface/markers/marker_colours.h>
#include <ros_interface/markers/marker_shapes.h>
#include <ros_interface/node/names.h>

namespace cable_variation_ros {

using cable_variation::EnvelopePiece;
using cable_variation::Scene;
using visualization_msgs::Marker;
using visualization_msgs::MarkerArray;

namespace {

constexpr double kOpacity = 0.35;    // what is inside stays to be seen, through two walls
constexpr double kEdgeWidth = 2e-4;  // [m]

}  // namespace

MarkerArray envelopeMarkers(const Scene& scene, const std::vector<cable_variation::CableSurface>& surfaces) {
  MarkerArray array;
  for (const cable_variation::CableSurface& surface : surfaces) {
    Eigen::Vector4d colour = cableColour(surface.cable);
    colour[3] = kOpacity;
    MarkerGroup group(kEnvelopeMarkers + scene.harness.cables[surface.cable].name, kWorldFrame, colour);
    group.addMesh({}, surface.mesh);
    array.markers.insert(array.markers.end(), group.markers().begin(), group.markers().end());
  }
  return array;
}

MarkerArray pieceMarkers(const Scene& scene, const std::vector<EnvelopePiece>& pieces) {
  std::map<std::size_t, Marker> edges;  // by cable
  for (const EnvelopePiece& piece : pieces) {
    Marker& marker = edges[piece.cable];
    const cable_variation::TriangleMesh& hull = piece.body.core.surface();
    for (const auto& triangle : hull.triangles) {
      for (std::size_t k = 0; k < 3; ++k) {
        const std::uint32_t from = triangle[k], to = triangle[(k + 1) % 3];
        if (from > to) continue;  // the neighbour's
        marker.points.push_back(toPoint(hull.vertices[from]));
        marker.points.push_back(toPoint(hull.vertices[to]));
      }
    }
  }
  MarkerArray array;
  for (auto& [cable, marker] : edges) {
    marker.header.frame_id = kWorldFrame;
    marker.ns = kEnvelopeMarkers + scene.harness.cables[cable].name + "/pieces";
    marker.type = Marker::LINE_LIST;
    marker.action = Marker::ADD;
    marker.pose.orientation.w = 1.0;
    marker.scale.x = kEdgeWidth;
    const Eigen::Vector4f colour = cableColour(cable).cast<float>();
    marker.color.r = colour[0];
    marker.color.g = colour[1];
    marker.color.b = colour[2];
    marker.color.a = 1.0F;
    array.markers.push_back(std::move(marker));
  }
  return array;
}

}  // namespace cable_variation_ros
