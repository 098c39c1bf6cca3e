#pragma once

#include <functional>
#include <vector>

#include <cable_variation/envelope/envelope.h>
#include <cable_variation/geometry/body/outer_surface.h>
#include <ros_interface/markers/envelope_markers.h>
#include <ros_interface/runs/envelope_task.h>

namespace cable_variation_ros {

/// The surfaces of an envelope, as seen from the world.
struct EnvelopeSurfaces {
  cable_variation::OuterSurface whole;
  std::vector<CableSurface> by_cable;
};

/// @param check called now and then, by any thread; may throw, which ends the work
EnvelopeSurfaces envelopeSurfaces(const EnvelopeTask& task, const cable_variation::Envelope& envelope,
                                  const std::function<void()>& check);

/// Throws std::invalid_argument, with what would be possible, if already the nominal cables alone would take
/// a mesh of more memory than the task allows.
void refuseFinerMeshThanMemory(const EnvelopeTask& task, const cable_variation::Scene& scene);

}  // namespace cable_variation_ros
