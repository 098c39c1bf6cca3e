#pragma once

#include <cable_variation/geometry/mesh/triangle_mesh.h>
#include <cable_variation/scene/scene.h>

namespace cable_variation {

/// A component's visuals as one mesh in its frame, one after the other: what distances are measured to.
TriangleMesh mergedMesh(const Component& component);

}  // namespace cable_variation
