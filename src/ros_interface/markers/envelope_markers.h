#pragma once

#include <vector>

#include <visualization_msgs/MarkerArray.h>

#include <cable_variation/envelope/envelope.h>
#include <cable_variation/geometry/mesh/triangle_mesh.h>

namespace cable_variation_ros {

/// The outer surface of one cable's envelope.
struct CableSurface {
  std::size_t cable = 0;               ///< index
  cable_variation::TriangleMesh mesh;  ///< world
};

/// Each surface in its cable's colour, lit and translucent, namespace envelope/CABLE.
visualization_msgs::MarkerArray envelopeMarkers(const cable_variation::Scene& scene,
                                                const std::vector<CableSurface>& surfaces);

/// The edges of the convex pieces' cores, namespace envelope/CABLE/pieces.
visualization_msgs::MarkerArray pieceMarkers(const cable_variation::Scene& scene,
                                             const std::vector<cable_variation::EnvelopePiece>& pieces);

}  // namespace cable_variation_ros
