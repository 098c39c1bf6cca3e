#pragma once

#include <cable_variation/scene/design.h>

namespace cable_variation {

/// Adds a cable that the scene does not have. Nothing holds it yet: clips are to be added. Throws
/// std::invalid_argument for what is none, and for a name that another has.
void addCable(Design& design, Cable cable);

}  // namespace cable_variation
