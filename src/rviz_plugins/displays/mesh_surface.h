#pragma once

#include <rviz_plugins/displays/surface.h>

namespace cable_variation_rviz {

/// A mesh with normals: smooth over edges flatter than `crease`, sharp over the others.
/// @param positions of vertices [m]
/// @param triangles three vertices each, counter-clockwise seen from outside; flat ones are left out
/// @param crease angle between neighbours from which on their edge is seen [rad]
Surface meshSurface(const std::vector<Eigen::Vector3f>& positions,
                    const std::vector<std::uint32_t>& triangles, float crease);

}  // namespace cable_variation_rviz
