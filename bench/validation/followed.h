#pragma once

#include <functional>

#include <cable_variation/harness/harness.h>

namespace cable_variation::validation {

/// The largest parameter that a family of harnesses is followed to, from `low` on: one shape follows the
/// other by small steps; where it moves by more than `jump` [m] in one, however short, or is no longer found,
/// it has snapped. To a share of 1e-4; `most`, or nearly, if it never does. Throws as requireConverged() at
/// `low`.
double followedTo(const std::function<Harness(double)>& at, double low, double step, double most,
                  double jump);

}  // namespace cable_variation::validation
