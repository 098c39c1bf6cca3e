#pragma once

#include <string>
#include <utility>
#include <vector>

#include <cable_variation/harness/harness_rate.h>
#include <cable_variation/scene/scene.h>

namespace cable_variation {

/// How a scene changes with one of its design variables, to first order, per unit of it.
struct DesignRate {
  HarnessRate harness;
  std::vector<std::pair<std::size_t, FrameRate>>
      components;  ///< those that move, by index into Scene::components
};

/// At the design that harnessAt(scene, values, moved) gives: its analytic derivative.
/// One per entry of `variables` (indices into Scene::design_variables).
/// Throws std::invalid_argument as harnessAt().
std::vector<DesignRate> designRates(const Scene& scene, const DesignValues& values,
                                    const ComponentPoses& moved, const std::vector<std::size_t>& variables);

}  // namespace cable_variation
