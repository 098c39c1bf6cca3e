#pragma once

#include <vector>

#include <Eigen/Geometry>
#include <visualization_msgs/Marker.h>

#include <cable_variation/geometry/mesh/triangle_mesh.h>
#include <cable_variation/math/pose.h>

namespace cable_variation_ros {

/// Colours by vertex into a TRIANGLE_LIST. RViz does not light a list that has colours of its own, so a
/// light is mixed in here: it darkens by at most a third and leaves the hue as the legend has it. Points
/// lie `lift` outside the surface, so as to cover the same mesh shown there in another colour.
/// @param pose of the mesh in the marker's frame
/// @param orientation of the mesh in the world: the light comes from above and the front
/// @param colors r g b, one per vertex
/// @param lift [m]
void addColouredMesh(const cable_variation::TriangleMesh& mesh, const cable_variation::Pose& pose,
                     const Eigen::Quaterniond& orientation, const std::vector<Eigen::Vector3d>& colors,
                     double lift, visualization_msgs::Marker& marker);

}  // namespace cable_variation_ros
