#pragma once

#include <cable_variation/scene/scene.h>

namespace cable_variation {

/// The value that a design variable of the property has in this cable: at its
/// start (EI: about y); of the rest curvature, 1.
double propertyOf(const Cable& cable, CableProperty::Property property);

/// Sets a property of a cable, all along it in proportion to `value` over `nominal`
/// (its value in the scene; of no concern to a length); a new length moves
/// what is attached: at the end it stays there, else it keeps its distance from
/// the start, or with clips_scale its fraction of the length (then sections and
/// rest shape are stretched too, else they are cut off or go on as they end).
/// Throws std::invalid_argument that names the cable, the value and the bound.
void setProperty(Harness& harness, const CableProperty& target, double value, double nominal);

}  // namespace cable_variation
