#pragma once

#include <vector>

#include <visualization_msgs/MarkerArray.h>

#include <cable_variation/envelope/clearance/envelope_clearance.h>
#include <ros_interface/markers/interference_markers.h>

namespace cable_variation_ros {

/// What is this close is worth showing, interfering or not [m].
constexpr double kWorthShowing = 0.02;

/// The closest pairs of an envelope worth showing, namespace interference/clearance/CABLE/OTHER: those that
/// interfere, that is overlap or come closer than the lower limit of the scene's distance measures (two
/// cables: in a shape that was solved); and of each component and each pair of cables the closest one, if
/// that is within kWorthShowing.
/// @param moving whether texts tell times
std::vector<DistanceMark> clearanceMarks(const cable_variation::Scene& scene,
                                         const std::vector<cable_variation::EnvelopeClearance>& clearances,
                                         bool moving);

/// The triangles of a component's mesh (its visuals' in order) with these numbers: red, 0.3 mm off both sides
/// of the surface, in namespace interference/triangles/COMPONENT. They ride on the component's frame, in
/// which it is at `deviation`. None: no markers.
std::vector<visualization_msgs::Marker> triangleMarkers(const cable_variation::Component& component,
                                                        const std::vector<std::uint32_t>& triangles,
                                                        const cable_variation::Pose& deviation);

/// Red triangles of a mesh at `pose` in `frame`, as above.
std::vector<visualization_msgs::Marker> triangleMarkers(const std::string& marker_namespace,
                                                        const std::string& frame,
                                                        const cable_variation::TriangleMesh& mesh,
                                                        const std::vector<std::uint32_t>& triangles,
                                                        const cable_variation::Pose& pose);

/// A component's colliding triangles with all cables, each once.
std::vector<std::uint32_t> collidingTriangles(
    const std::vector<cable_variation::EnvelopeClearance>& clearances, const std::string& component);

}  // namespace cable_variation_ros
