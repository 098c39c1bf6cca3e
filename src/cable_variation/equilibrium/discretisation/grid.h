#pragma once  // internal to equilibrium/

#include <cable_variation/equilibrium/discretisation/configuration.h>

namespace cable_variation {

/// The coarsest grid that is worth starting from: per span an even number of
/// equal elements, more for a span that makes up much of its cable, and for a twist
/// that is asked for.
Grid startGrid(const Harness& harness, const Topology& topology);

/// Each pair of elements (2k, 2k + 1) of span i split into two pairs where marked[i][k].
Grid refine(const Grid& grid, const std::vector<std::vector<bool>>& marked);

/// Every pair of elements merged into one.
Grid coarsen(const Grid& grid);

/// The same shape on another grid, from the elements' own polynomials.
Configuration transfer(const Configuration& configuration, const Grid& from, const Grid& to);

}  // namespace cable_variation
