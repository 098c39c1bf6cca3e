#pragma once

#include <optional>
#include <string>

#include <cable_variation/GenerateEnvelope.h>

#include <cable_variation/envelope/envelope_generator.h>
#include <cable_variation/scene/design.h>

namespace cable_variation_ros {

/// What a request for an envelope asks for, checked and with its defaults.
struct EnvelopeTask {
  cable_variation::EnvelopeOptions options;
  bool other_design = false;              ///< nominal values were given
  double mesh_memory = 4e8;               ///< that the mesh may take [B]
  double mesh_excess = 0.0;               ///< [m]; 0: what the usual number of triangles allows
  std::optional<double> skip_near_clips;  ///< [m]; none: as the scene's distance measures have it
  std::string name;                       ///< of the files; empty: none
  bool show_pieces = false;
};

/// @param moved components that are not where the scene has them now @param memory_limit of the request [B]
/// Throws cable_variation::NotFound for a name that is none, and std::invalid_argument that names the field,
/// its value and what is expected.
EnvelopeTask toEnvelopeTask(const cable_variation::GenerateEnvelopeRequest& request,
                            const cable_variation::Design& design,
                            const cable_variation::ComponentPoses& moved, std::size_t threads,
                            double memory_limit);

}  // namespace cable_variation_ros
