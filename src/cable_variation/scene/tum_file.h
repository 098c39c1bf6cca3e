#pragma once

#include <string>

#include <cable_variation/scene/motion.h>
#include <cable_variation/util/input_limits.h>

namespace cable_variation {

/// readTum() of scene/motion.h, but with other limits than the default ones: a larger file, or one with
/// more poses, is refused.
void readTum(const std::string& path, Motion& motion, const InputLimits& limits);

}  // namespace cable_variation
