#pragma once  // internal to report/

#include <string>
#include <vector>

#include <cable_variation/equilibrium/equilibrium.h>
#include <cable_variation/measures/measure_evaluation.h>
#include <cable_variation/report/picture/camera.h>
#include <cable_variation/report/picture/raster.h>

namespace cable_variation {

/// A harness among its parts, drawn: parts in their colours, cables in theirs, what a part hides of them
/// pale, an envelope translucent. Opaque where something is; the rest is left to the page.
struct ScenePicture {
  std::string png;  ///< the file's bytes
  Camera camera;    ///< of its pixels: where a place of the world is seen
};

/// Of the cable of this index, in pictures and in charts: told apart with every colour vision (Okabe and Ito
/// 2008).
Colour cablePaint(std::size_t cable);

/// From above, where as much of the cables is seen as from any of the places tried.
/// @param envelope surfaces around the cables [m, world]; empty: none
/// Throws std::invalid_argument: the harness has no cable.
ScenePicture scenePicture(const Scene& scene, const SolvedScene& solved,
                          const std::vector<const TriangleMesh*>& envelope = {});

}  // namespace cable_variation
