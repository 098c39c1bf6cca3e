#pragma once

#include <cable_variation/equilibrium/equilibrium.h>
#include <command/json.h>

namespace cable_variation_command {

/// As SolveEquilibrium answers it, but for status, measures, warnings and report. @param harness that was
/// solved
Json equilibriumJson(const cable_variation::Equilibrium& equilibrium,
                     const cable_variation::Harness& harness);

}  // namespace cable_variation_command
