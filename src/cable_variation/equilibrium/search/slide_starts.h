#pragma once  // internal to equilibrium/

#include <vector>

#include <cable_variation/equilibrium/discretisation/configuration.h>

namespace cable_variation {

/// Where the search for sliding clips may start: each entry holds an arc length per station [m], sliding ones
/// moved. Per piece of cable between two stations that do not slide: its slack shared out by the distances
/// from clip to clip; all of it behind the sliding clips, before them, or in their middle. Empty when nothing
/// slides.
std::vector<std::vector<double>> slideStarts(const Harness& harness, const Topology& topology);

}  // namespace cable_variation
