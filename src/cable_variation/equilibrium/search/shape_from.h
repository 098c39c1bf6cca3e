#pragma once  // internal to equilibrium/

#include <memory>
#include <vector>

#include <cable_variation/equilibrium/search/branch.h>

namespace cable_variation {

/// The stable shape that `harness` comes to rest in when it is let go at `shapes`, one per cable, on a grid
/// of the accuracy asked for, with its gradient at hand. None: the result says why. Throws
/// std::invalid_argument for shapes of other cables (and makeTopology()).
std::unique_ptr<Branch> shapeFrom(const Harness& harness, const std::vector<CableShape>& shapes,
                                  const EquilibriumOptions& options, Equilibrium& result);

}  // namespace cable_variation
