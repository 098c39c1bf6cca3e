#pragma once

#include <string>
#include <vector>

#include <cable_variation/scene/design.h>

namespace cable_variation {

// Implausible edits of a design, judged as a scene file's figures without a unit.

/// Of the design as a whole: cables that are too long, too thick, too stiff or too heavy for what they are,
/// clips out of their reach, variables that shift or turn by more than anybody means. Each names the thing
/// and the value, and what was probably meant.
std::vector<std::string> slipsOf(const Design& design);

/// Those of `edited` that `before` does not have.
std::vector<std::string> newSlips(const Design& before, const Design& edited);

/// Of a rotation by an angle [rad], either way; empty: nothing to say.
std::string turnSlip(double angle);

/// Of a clip that is shifted by a distance [m]; empty: nothing to say.
std::string shiftSlip(const Scene& scene, double distance);

}  // namespace cable_variation
