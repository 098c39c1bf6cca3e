#pragma once

#include <optional>
#include <string>

#include <cable_variation/analysis/requests.h>
#include <cable_variation/envelope/envelope_generator.h>
#include <cable_variation/scene/design.h>

namespace cable_variation {

/// What a request for an envelope asks for, checked and with its defaults.
struct EnvelopeTask {
  EnvelopeOptions options;
  bool other_design = false;              ///< nominal values were given
  double mesh_memory = 4e8;               ///< that the mesh may take [B]
  double mesh_excess = 0.0;               ///< [m]; 0: what the usual number of triangles allows
  std::optional<double> skip_near_clips;  ///< [m]; none: as the scene's distance measures have it
  std::string name;                       ///< of the files; empty: none
};

/// @param moved components that are not where the scene has them now @param memory_limit of the request [B]
/// Throws NotFound for a name that is none, and std::invalid_argument that names the field,
/// its value and what is expected.
EnvelopeTask toEnvelopeTask(const EnvelopeRequest& request, const Design& design, const ComponentPoses& moved,
                            std::size_t threads, double memory_limit);

}  // namespace cable_variation
