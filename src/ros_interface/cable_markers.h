#pragma once

#include <visualization_msgs/MarkerArray.h>

#include <cable_variation/harness/equilibrium.h>

namespace cable_variation_ros {

/// Cables with their true thickness, namespace cable/NAME; nothing unless the
/// equilibrium converged.
///
/// A cable is a chain of meshes/cable_segment.obj, at most 2° of bend each, which
/// RViz lights with smooth normals. A TRIANGLE_LIST would be flat-shaded (not lit
/// at all if coloured by vertex) and take ten times the bytes; CYLINDERs have lids
/// that shine through as specks where two meet.
visualization_msgs::MarkerArray cableMarkers(const cable_variation::Equilibrium& equilibrium,
                                             const cable_variation::Harness& harness);

}  // namespace cable_variation_ros
