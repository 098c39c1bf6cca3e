#pragma once

#include <cable_variation/simulation/simulation.h>
#include <command/json.h>

namespace cable_variation_command {

/// As SimulateVariation answers it, but for status and files. @param values of the design simulated
Json simulationJson(const cable_variation::Scene& scene, const cable_variation::DesignValues& values,
                    const cable_variation::Simulation& simulation);

}  // namespace cable_variation_command
