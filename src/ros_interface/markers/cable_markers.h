#pragma once

#include <functional>

#include <visualization_msgs/MarkerArray.h>

#include <cable_variation/equilibrium/equilibrium.h>
#include <ros_interface/markers/marker_shapes.h>

namespace cable_variation_ros {

/// How a cable is drawn.
struct CableLook {
  double thickness = 1.0;                        ///< times its own
  double longest_segment = 0.02;                 ///< [m]; colours change from one to the next
  std::function<Eigen::Vector4d(double)> color;  ///< r g b a at an arc length [m]; empty: the group's
};

/// Adds a cable to `group`, a chain of meshes/cable_segment.obj, at most 2° of bend
/// each, which RViz lights with smooth normals. A TRIANGLE_LIST would be flat-shaded
/// (not lit at all if coloured by vertex) and take ten times the bytes; CYLINDERs
/// have lids that shine through as specks where two meet.
void addCable(MarkerGroup& group, const cable_variation::CableShape& shape,
              const cable_variation::Cable& cable, const CableLook& look);

/// Cables with their true thickness, namespace cable/NAME; nothing unless the
/// equilibrium converged.
/// @param outdated grey: the cables were like that once, and there is no equilibrium now
visualization_msgs::MarkerArray cableMarkers(const cable_variation::Equilibrium& equilibrium,
                                             const cable_variation::Harness& harness, bool outdated = false);

}  // namespace cable_variation_ros
