#pragma once  // internal to equilibrium/

#include <cable_variation/equilibrium/discretisation/rod_system.h>

namespace cable_variation {

/// The largest out-of-balance force that counts as none: rounding, or a share of what the softest bending
/// takes [N]. After an evaluation.
double residualTolerance(const RodSystem& system);

/// The shift that counts as none: small enough not to slow Newton's method,
/// large enough to let motions that cost no energy (a round cable turning in
/// ball joints) pass as stable.
constexpr double kNeutralShift = 1e-9;
/// The same, where rounding is larger: after an evaluation.
double neutralShift(const RodSystem& system);

}  // namespace cable_variation
