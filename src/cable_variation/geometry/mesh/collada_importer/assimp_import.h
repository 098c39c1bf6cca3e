#pragma once  // internal to geometry/

#include <string>

#include <cable_variation/geometry/mesh/imported_mesh.h>

namespace cable_variation {

/// All meshes of a COLLADA document, in its frame with its nodes' transforms and its unit applied, its up
/// axis not; polygons divided. By assimp, of which only this importer looks at it. Throws
/// std::invalid_argument: not readable, or more triangles than this.
ImportedMesh importCollada(const std::string& document, std::size_t most_triangles);

}  // namespace cable_variation
