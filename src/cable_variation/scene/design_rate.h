#pragma once

#include <array>
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
/// Throws std::invalid_argument: an index out of range, an unknown name, a value that is not finite,
/// deviations that locators cannot take, or a cable's property of value 0, of which a relative change has no
/// meaning. Whether values leave the physical, harnessAt() tells.
std::vector<DesignRate> designRates(const Scene& scene, const DesignValues& values,
                                    const ComponentPoses& moved, const std::vector<std::size_t>& variables);

/// At the same design: how the scene changes when a component, with all that rides on it, moves as a rigid
/// body: per metre along the world's x, y and z, then per radian about them through the component's origin.
/// Throws std::invalid_argument as designRates().
std::array<DesignRate, 6> rigidMotionRates(const Scene& scene, const DesignValues& values,
                                           const ComponentPoses& moved, const std::string& component);

}  // namespace cable_variation
