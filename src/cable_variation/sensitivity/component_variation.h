#pragma once

#include <vector>

#include <Eigen/Core>

#include <cable_variation/scene/scene.h>

namespace cable_variation {

/// How production moves one rigid part: to first order a Gaussian-like cloud of small rigid motions.
struct ComponentVariation {
  std::size_t component = 0;                         ///< index into Scene::components
  Eigen::Vector3d origin = Eigen::Vector3d::Zero();  ///< of its frame at the design [m, world]
  /// Mean and covariance of its motion off the design: translation of the origin [m], then
  /// rotation vector [rad]; world.
  Eigen::Matrix<double, 6, 1> mean = Eigen::Matrix<double, 6, 1>::Zero();
  Eigen::Matrix<double, 6, 6> covariance = Eigen::Matrix<double, 6, 6>::Zero();
};

/// The design variables of a component itself: its locators, translations and rotations; not of what it
/// rides on.
std::vector<std::size_t> ownVariables(const Scene& scene, std::size_t component);

/// From the spread of `variables` (indices into Scene::design_variables; those that do not move the
/// component count nothing) at the design that componentPosesAt(scene, values, moved) gives. First order: a
/// turn by an angle θ about a point leaves an error of θ²/2 of the distance from it.
/// Throws std::invalid_argument: an index out of range, designRates(), spreadOf().
ComponentVariation componentVariation(const Scene& scene, std::size_t component,
                                      const std::vector<std::size_t>& variables,
                                      const DesignValues& values = {}, const ComponentPoses& moved = {});

/// How a point of the part varies.
struct PointVariation {
  Eigen::Vector3d point = Eigen::Vector3d::Zero();  ///< at the design [m, world]
  /// Six standard deviations along the direction in which the point varies most [m].
  double six_sigma = 0.0;
  Eigen::Vector3d direction = Eigen::Vector3d::Zero();   ///< that direction, unit, world; zero: no variation
  Eigen::Vector3d mean_shift = Eigen::Vector3d::Zero();  ///< off the design [m, world]
};

/// @param point of the part at the design [m, world]
PointVariation variationAt(const ComponentVariation& variation, const Eigen::Vector3d& point);

/// The vertex of the component's visuals with the largest six_sigma; its origin if it has no vertices.
/// @param pose of the component at the design, world (componentPosesAt())
PointVariation largestVariation(const Scene& scene, const ComponentVariation& variation, const Pose& pose);

}  // namespace cable_variation
