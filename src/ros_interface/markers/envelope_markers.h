#pragma once

#include <vector>

#include <visualization_msgs/MarkerArray.h>

#include <cable_variation/analysis/envelope_surfaces.h>
#include <cable_variation/envelope/envelope.h>

namespace cable_variation_ros {

/// Each surface in its cable's colour, lit and translucent, namespace envelope/CABLE.
visualization_msgs::MarkerArray envelopeMarkers(const cable_variation::Scene& scene,
                                                const std::vector<cable_variation::CableSurface>& surfaces);

/// The edges of the convex pieces' cores, namespace envelope/CABLE/pieces.
visualization_msgs::MarkerArray pieceMarkers(const cable_variation::Scene& scene,
                                             const std::vector<cable_variation::EnvelopePiece>& pieces);

}  // namespace cable_variation_ros
