#pragma once

#include <cable_variation/geometry/mesh/triangle_mesh.h>

namespace cable_variation {

/// Within closed surfaces that face outward [m³]; 0 without triangles.
double volumeWithin(const TriangleMesh& mesh);

}  // namespace cable_variation
