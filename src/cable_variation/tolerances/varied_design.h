#pragma once

#include <vector>

#include <cable_variation/scene/scene.h>

namespace cable_variation {

/// A design, and what production and its motions do to it.
struct VariedDesign {
  std::vector<std::size_t> variables;  ///< indices; vary within their tolerances
  std::vector<std::size_t> motions;    ///< indices into Scene::motions, played together; empty: at rest
  DesignValues values;                 ///< nominal values other than the scene's
  ComponentPoses moved;                ///< at rest: components that are not where the scene has them
};

}  // namespace cable_variation
