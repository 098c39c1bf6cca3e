#pragma once

#include <cable_variation/scene/scene.h>

namespace cable_variation {

/// Whether a variable's value is the quantity itself, not a deviation.
bool setsQuantity(const DesignTarget& target);

/// Whether both set one and the same quantity.
bool sameQuantity(const DesignTarget& a, const DesignTarget& b);

}  // namespace cable_variation
