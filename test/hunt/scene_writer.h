#pragma once

#include <string>

#include <cable_variation/harness/harness.h>

namespace cable_variation::hunt {

/// The harness as a scene file (doc/scene_file.md), with all figures; `remark` as its first lines.
std::string sceneOf(const Harness& harness, double accuracy, const std::string& remark);

}  // namespace cable_variation::hunt
