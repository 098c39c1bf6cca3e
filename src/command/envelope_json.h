#pragma once

#include <cable_variation/analysis/envelope_calculation.h>
#include <command/json.h>

namespace cable_variation_command {

/// As GenerateEnvelope answers it, but for status, mesh, warnings and files.
Json envelopeJson(const cable_variation::Scene& scene, const cable_variation::EnvelopeTask& task,
                  const cable_variation::EnvelopeCalculation& found);

}  // namespace cable_variation_command
