#pragma once

#include <cstdint>
#include <vector>

#include <Eigen/Core>

namespace cable_variation_rviz {

/// Triangles with a normal at each vertex, counter-clockwise seen from outside.
struct Surface {
  std::vector<Eigen::Vector3f> positions;  ///< [m]
  std::vector<Eigen::Vector3f> normals;    ///< unit ones
  std::vector<std::uint32_t> triangles;    ///< three vertices each
};

/// The tube around a line of stations, closed with flat ends, with the station that each vertex is of.
struct TubeSurface : Surface {
  std::vector<std::uint32_t> stations;
};

/// Smooth along the tube and around it. Fewer than two stations: nothing.
/// @param line the stations [m]; where two are in one place the direction of those before goes on
/// @param radii one for each [m]
/// @param sides vertices around
TubeSurface tubeSurface(const std::vector<Eigen::Vector3f>& line, const std::vector<float>& radii,
                        std::uint32_t sides);

}  // namespace cable_variation_rviz
