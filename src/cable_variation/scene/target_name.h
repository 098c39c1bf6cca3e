#pragma once

#include <string>

#include <cable_variation/scene/scene.h>

namespace cable_variation {

/// What a design variable moves or scales, in words for programs: the message DesignVariableInfo has them
/// all.
struct TargetName {
  std::string kind;    ///< such as "clip_rotation"
  std::string target;  ///< the clip, cable, joint or component
  std::string member;  ///< x, y or z; of a cable the property; of a locator its number
};

TargetName nameOf(const DesignTarget& target, const Scene& scene);

}  // namespace cable_variation
