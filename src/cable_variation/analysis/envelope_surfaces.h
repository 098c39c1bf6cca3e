#pragma once

#include <functional>
#include <vector>

#include <cable_variation/envelope/envelope.h>
#include <cable_variation/geometry/body/outer_surface.h>
#include <cable_variation/geometry/mesh/triangle_mesh.h>
#include <cable_variation/analysis/envelope_task.h>

namespace cable_variation {

/// The outer surface of one cable's envelope.
struct CableSurface {
  std::size_t cable = 0;  ///< index
  TriangleMesh mesh;      ///< world
};

/// The surfaces of an envelope, as seen from the world.
struct EnvelopeSurfaces {
  OuterSurface whole;
  std::vector<CableSurface> by_cable;  ///< empty unless asked for
};

/// @param by_cable whether each cable's by itself is wanted too
/// @param check called now and then, by any thread; may throw, which ends the work
EnvelopeSurfaces envelopeSurfaces(const EnvelopeTask& task, const Envelope& envelope, bool by_cable,
                                  const std::function<void()>& check);

/// Throws std::invalid_argument, with what would be possible, if already the nominal cables alone would take
/// a mesh of more memory than the task allows.
void refuseFinerMeshThanMemory(const EnvelopeTask& task, const Scene& scene);

}  // namespace cable_variation
