#pragma once  // internal to simulation/

#include <cable_variation/scene/scene.h>
#include <cable_variation/simulation/simulation.h>

namespace cable_variation {

/// Options with all measures named. Throws std::invalid_argument that names what cannot be.
SimulationOptions checkedOptions(const Scene& scene, SimulationOptions options);

}  // namespace cable_variation
