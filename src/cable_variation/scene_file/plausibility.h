#pragma once

#include <string>

#include <cable_variation/scene/scene.h>
#include <cable_variation/scene_file/yaml_cursor.h>

namespace cable_variation {

/// Warns of implausible values in a scene without faults: a figure in another
/// unit than it seems to be in, most often. `root` is the file that `scene` was read from.
/// Each warning names the thing and the value, and what was probably meant.
void warnOfSlips(const YamlCursor& root, const Scene& scene);

/// Those of one motion, once its samples are there: "" if there is nothing to say.
std::string slipOf(const Motion& motion, const Scene& scene);

}  // namespace cable_variation
