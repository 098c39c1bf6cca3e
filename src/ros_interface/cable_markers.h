#pragma once

#include <visualization_msgs/MarkerArray.h>

#include <cable_variation/harness/equilibrium.h>

namespace cable_variation_ros {

/// Cables with their true thickness, namespace cable/NAME; nothing unless the
/// equilibrium converged.
///
/// A cable is a chain of CYLINDER markers, at most 2° of bend each: RViz gives
/// cylinders smooth normals and lights them, while a TRIANGLE_LIST is flat-shaded
/// and, if coloured by vertex, not lit at all; and the chain is a fifteenth of the bytes.
visualization_msgs::MarkerArray cableMarkers(const cable_variation::Equilibrium& equilibrium,
                                             const cable_variation::Harness& harness);

}  // namespace cable_variation_ros
