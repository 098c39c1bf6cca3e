#pragma once

#include <cable_variation/harness/equilibrium.h>
#include <cable_variation/harness/linear_response.h>

namespace cable_variation {

/// What a variable of the harness does to its stations at `configuration`.
HarnessChange changeOf(const Harness& harness, const Topology& topology, const StationUnknowns& unknowns,
                       const Configuration& configuration, const HarnessRate& rate);

/// The largest of what a change and its response do: turns [rad], shifts over `length`, and relative changes.
double sizeOf(const HarnessChange& change, const HarnessResponse& response, double length);

/// How the solved cables change, to first order.
/// @param shapes of the equilibrium itself
EquilibriumRate equilibriumRate(const Harness& harness, const Topology& topology,
                                const std::vector<CableShape>& shapes, const HarnessChange& change,
                                const HarnessResponse& response);

}  // namespace cable_variation
