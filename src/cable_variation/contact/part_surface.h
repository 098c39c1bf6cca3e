#pragma once

#include <memory>

#include <cable_variation/geometry/mesh/triangle_mesh.h>
#include <cable_variation/geometry/tube_distance/distance.h>
#include <cable_variation/harness/contact.h>

namespace cable_variation {

/// What cables touch of a part with this mesh, by exact distances to its triangles. Throws
/// std::invalid_argument for a mesh without triangles.
std::shared_ptr<const ContactSurface> makePartSurface(const TriangleMesh& mesh);
/// The same of a part that is prepared already.
std::shared_ptr<const ContactSurface> makePartSurface(std::shared_ptr<const DistancePart> part);

}  // namespace cable_variation
