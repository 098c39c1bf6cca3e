#pragma once

#include <cable_variation/analysis/simulation_calculation.h>
#include <command/verb.h>

namespace cable_variation_command {

/// What a simulation of a scene found, as `simulate` and `merge` answer it.
Answer simulationAnswer(const cable_variation::Scene& scene, const cable_variation::DesignValues& values,
                        const cable_variation::SimulationCalculation& found);

}  // namespace cable_variation_command
