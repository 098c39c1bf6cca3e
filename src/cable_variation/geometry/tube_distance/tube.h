#pragma once

#include <cstddef>
#include <vector>

#include <cable_variation/geometry/mesh/triangle_mesh.h>
#include <cable_variation/math/pose.h>

namespace cable_variation {

/// A tube swept along `path`: a ring of `sides` vertices in the y-z plane of
/// each pose, `radius` [m] from its origin; consecutive rings are joined ring
/// vertex by ring vertex, so the poses should twist little from one to the next.
/// `closed` joins the last ring to the first; otherwise both ends get flat caps.
/// The mesh is watertight. Vertex k of ring i is number i * sides + k.
/// Throws std::invalid_argument unless radius > 0, sides >= 3 and there are at
/// least two poses (closed: three).
TriangleMesh tubeMesh(const std::vector<Pose>& path, double radius, std::size_t sides, bool closed = false);

}  // namespace cable_variation
