#pragma once

#include <cable_variation/harness/equilibrium.h>
#include <cable_variation/harness/rod_system.h>

namespace cable_variation {

/// The solved cables, from a system that holds the gradient at `configuration`.
std::vector<CableShape> describeShapes(const Harness& harness, const Topology& topology,
                                       const RodSystem& system, const Configuration& configuration);

/// The configuration on another grid, its nodes taken from the shapes: their
/// points are the most accurate that a grid gives, better than the elements'
/// own polynomials.
Configuration onGrid(const Topology& topology, const Configuration& configuration,
                     const std::vector<CableShape>& shapes, const Grid& grid);

/// Fills shapes, reactions and energy of `result` from a solved system, which
/// must hold the gradient at `configuration`.
void describe(const Harness& harness, const Topology& topology, const RodSystem& system,
              const Configuration& configuration, Equilibrium& result);

/// The largest distance between two shapes of one harness, at equal arc length [m].
double largestDistance(const Grid& grid_a, const Configuration& a, const Grid& grid_b,
                       const Configuration& b);

/// The held places of a cable that are further apart than it can reach; empty
/// when there are none. A cable that must stretch by more than `stretch` cannot reach.
std::string unreachable(const Harness& harness, const Topology& topology, const Configuration& configuration,
                        double stretch);

/// Why a descent that ended in `configuration` may have failed: a sliding clip
/// that has come to the end of its room, else the piece of cable furthest from balance.
std::string whereItFailed(const Harness& harness, const Topology& topology, const RodSystem& system,
                          const Configuration& configuration);

}  // namespace cable_variation
