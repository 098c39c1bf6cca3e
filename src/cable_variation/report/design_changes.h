#pragma once

#include <string>
#include <vector>

#include <cable_variation/scene/scene.h>

namespace cable_variation {

/// What an edited scene has other than the scene it was made of, a text each: "length of cable main 312 → 315
/// mm". Both must have the same components, cables and design variables; clips may have been added.
/// @param shifts of components, see Design::shifts
std::vector<std::string> designChanges(const Scene& loaded, const Scene& edited,
                                       const ComponentPoses& shifts = {});

}  // namespace cable_variation
