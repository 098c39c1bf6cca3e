#pragma once

#include <string>
#include <vector>

#include <cable_variation/scene/scene.h>

namespace cable_variation {

/// What an edited scene has other than the scene it was made of, a text each: "length of cable main 312 → 315
/// mm". Both must have the same cables, clips and design variables.
std::vector<std::string> designChanges(const Scene& loaded, const Scene& edited);

}  // namespace cable_variation
