#pragma once

#include <string>

#include <cable_variation/analysis/requests.h>
#include <cable_variation/scene/design.h>
#include <cable_variation/simulation/simulation.h>

namespace cable_variation {

/// What a request for a simulation asks for, checked and with its defaults.
struct SimulationTask {
  SimulationOptions options;
  bool other_design = false;  ///< nominal values were given
  std::string name;           ///< of the files; empty: none
};

/// @param moved components that are not where the scene has them now
/// Throws NotFound for a name that is none, and std::invalid_argument that names the field,
/// its value and what is expected.
SimulationTask toSimulationTask(const SimulationRequest& request, const Design& design,
                                const ComponentPoses& moved, std::size_t threads, double memory_limit);

}  // namespace cable_variation
