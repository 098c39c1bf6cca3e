#pragma once

#include <vector>

#include <cable_variation/geometry/tube_distance/distance.h>
#include <cable_variation/math/surface_place.h>

namespace cable_variation {

/// Adds the places of a part's surface nearest to x, each among those about it, that are closer than `within`
/// [m]; all in the part's frame. How a flat face is divided into triangles changes none of them: an edge
/// between facets of one plane is no edge. A place on an edge or a corner that x is not over is none.
void placesNear(const DistancePart& part, const Eigen::Vector3d& x, double within,
                std::vector<SurfacePlace>& places);

/// The distance of the part's surface from x [m, part's frame], or `within` if it is not closer.
double surfaceDistance(const DistancePart& part, const Eigen::Vector3d& x, double within);

}  // namespace cable_variation
