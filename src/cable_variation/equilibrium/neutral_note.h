#pragma once

#include <string>

#include <cable_variation/equilibrium/equilibrium.h>

namespace cable_variation {

/// What the note of an equilibrium with neutral motions begins with; what is free to move how follows.
extern const std::string kNeutralNote;

/// The note about motions that cost no energy (a round cable turning about its own axis in ball joints, a bow
/// between aligned clamps about their line): they are left out of Equilibrium::smallest_eigenvalue. Empty:
/// there are none, or the eigenvalue was not asked for.
std::string neutralNote(const Equilibrium& equilibrium);

}  // namespace cable_variation
