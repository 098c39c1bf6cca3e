#pragma once

#include <cable_variation/equilibrium/equilibrium.h>
#include <hunt/discrete_rod.h>
#include <hunt/draw.h>

namespace cable_variation::hunt {

/// A simple shape to start from: a cubic between neighbouring held places, bulging aside at random until it
/// is as long as the cable there; free places between their neighbours; sliding clips where they start, or
/// with `anywhere` at random in their room. Between two places the least twist that
/// fits, and `turns` more.
DiscreteShape simpleStart(const DiscreteRod& rod, Draw& draw, bool anywhere, int turns = 0);

/// The shape of a solver's answer, with its own section forces.
DiscreteShape startAt(const DiscreteRod& rod, const Equilibrium& answer);

}  // namespace cable_variation::hunt
