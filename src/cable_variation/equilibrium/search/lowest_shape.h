#pragma once  // internal to equilibrium/

#include <memory>

#include <cable_variation/equilibrium/search/branch.h>

namespace cable_variation {

/// The lowest of the stable shapes that the starts of searchStarts() lead to, on a grid of the accuracy asked
/// for, with its gradient at hand; or the saddle where there is none (Branch::unstable()). Shapes whose
/// energies the start grid cannot tell apart are compared on their refined grids, so none of the alternatives
/// put down in `result` is lower. With contact, starts that pass
/// through a part are left out; if all do, it is led out (ledOut()). None: the result says why.
std::unique_ptr<Branch> lowestShape(const Harness& harness, const EquilibriumOptions& options,
                                    Equilibrium& result);

/// The same, without leading starts that pass through parts out of them.
std::unique_ptr<Branch> lowestOfStarts(const Harness& harness, const EquilibriumOptions& options,
                                       Equilibrium& result);

}  // namespace cable_variation
