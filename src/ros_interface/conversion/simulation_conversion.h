#pragma once

#include <cable_variation/SimulateVariation.h>

#include <cable_variation/simulation/simulation.h>

namespace cable_variation_ros {

/// Everything but the status, files and the time they took.
/// @param values of the design simulated, as in SimulationOptions
cable_variation::SimulateVariationResponse toResponse(const cable_variation::Scene& scene,
                                                      const cable_variation::DesignValues& values,
                                                      const cable_variation::Simulation& simulation);

}  // namespace cable_variation_ros
