#pragma once

#include <string>

#include <cable_variation/equilibrium/equilibrium.h>

namespace cable_variation {

/// Throws unless the equilibrium converged, with `what` and its message: NotConverged, Unstable or
/// Impossible, as its status says.
/// @param what cannot go on without it, such as "the design has no equilibrium"; empty: the status's name
void requireConverged(const Equilibrium& equilibrium, const std::string& what = "");

}  // namespace cable_variation
