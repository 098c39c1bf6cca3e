#pragma once  // internal to equilibrium/

#include <memory>

#include <cable_variation/equilibrium/search/branch.h>

namespace cable_variation {

/// The shape of a harness whose starts all pass through parts that it has contact with. The parts in the way
/// of the natural start are taken away, straight along one direction, until they are clear of it; the harness
/// comes to rest there, and the parts are brought back and push the cables before them. So for each direction
/// along the world's and the parts' axes, the four shortest ways; the lowest of the shapes found counts, the
/// others are alternatives. None: the result says why, as before or by what the last direction met.
std::unique_ptr<Branch> ledOut(const Harness& harness, const EquilibriumOptions& options,
                               Equilibrium& result);

}  // namespace cable_variation
