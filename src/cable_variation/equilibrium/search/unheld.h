#pragma once  // internal to equilibrium/

#include <string>

#include <cable_variation/harness/harness.h>

namespace cable_variation {

/// Which cables, with those joined to them, nothing holds in place: every clip lets them slide through or go
/// on along an axis. Weight or a load may carry them off then, and no equilibrium be left. Empty: each is
/// held.
std::string unheldCables(const Harness& harness);

}  // namespace cable_variation
