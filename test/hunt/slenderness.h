#pragma once

#include <cable_variation/harness/harness.h>
#include <hunt/draw.h>

namespace cable_variation::hunt {

/// What holds a slender cable.
enum class Setting { fixed_ends, eyelet, sliding_rolling, sliding, free_end, aligned_clamps };

const char* toString(Setting setting);

/// One metre of a cable with κ = EA L²/EI, in random poses (method of the slenderness table, doc/hunt.md).
Harness slenderHarness(Draw& draw, Setting setting, double kappa);

/// Aligned clamps, no gravity: their distance is 1 - `slack` of the cable.
Harness alignedClamps(double kappa, double slack);

}  // namespace cable_variation::hunt
