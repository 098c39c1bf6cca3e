#pragma once

#include <array>
#include <utility>
#include <vector>

#include <cable_variation/scene/scene.h>

namespace cable_variation {

/// A small rigid motion in a frame's own axes: shift t [m], then rotation vector θ [rad].
struct Deviation {
  Eigen::Vector3d translation = Eigen::Vector3d::Zero();
  Eigen::Vector3d rotation = Eigen::Vector3d::Zero();

  Pose pose() const;
};

/// What values of design variables ask for, by the place of the things in the scene.
struct Deviations {
  std::vector<Deviation> clips;
  std::vector<Deviation> components;
  std::vector<std::array<double, 6>> locators;             ///< per component [m]
  std::vector<std::pair<std::size_t, double>> quantities;  ///< variable and value: of cables, arc lengths
};

/// Throws std::invalid_argument that names an unknown variable or a value that is not finite.
Deviations deviationsOf(const Scene& scene, const DesignValues& values);

/// A component's place in the world, in the steps that lead to it:
/// pose = base * located * (the component's own Deviation).
struct ComponentFrame {
  std::size_t parent = kWorld;
  Pose designed;  ///< without deviations: the scene's, or as `moved` tells
  Pose base;      ///< designed, carried along by the deviations of what it rides on
  Pose located;   ///< by its locators' deviations, in its frame
  Pose pose;

  static constexpr std::size_t kWorld = static_cast<std::size_t>(-1);
};

/// One per component of the scene. Throws std::invalid_argument: a parent that is not there or
/// that rides on its own child, deviations that locators cannot take (locatedPose()).
std::vector<ComponentFrame> componentFrames(const Scene& scene, const Deviations& deviations,
                                            const ComponentPoses& moved);

/// Index of the component, ComponentFrame::kWorld of "world".
/// Throws std::invalid_argument for an unknown name.
std::size_t componentIndex(const Scene& scene, const std::string& name);

}  // namespace cable_variation
