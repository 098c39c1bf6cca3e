#pragma once

#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

#include <cable_variation/rod/section.h>

namespace cable_variation {

/// A section at one arc length; between two of them the section is
/// interpolated linearly. Two at the same arc length make a step.
struct SectionAt {
  double arc_length = 0.0;  ///< [m]
  Section section;
};

/// Intrinsic (stress-free) strain Ω₀ at one arc length [1/m]: torsion about x,
/// bending about y and z, in the section's frame.
struct RestCurvatureAt {
  double arc_length = 0.0;  ///< [m]
  Eigen::Vector3d curvature = Eigen::Vector3d::Zero();
};

/// One cable or hose as made, before it is mounted.
struct Cable {
  std::string name;
  double length = 0.0;                          ///< undeformed [m]
  std::vector<SectionAt> sections;              ///< at least one; one alone means uniform
  std::vector<RestCurvatureAt> rest_curvature;  ///< empty: straight when free of stress

  /// Routing hints: points [m, world] the cable should pass near, in order
  /// from start to end. They choose among stable equilibria, they exert nothing.
  std::vector<Eigen::Vector3d> via;
  /// Routing hint: total twist from start to end about the tangent [rad] of the
  /// shape to look for; unset: the least.
  std::optional<double> twist;
};

/// The section at `arc_length`, which is clamped to [0, length].
Section sectionAt(const Cable& cable, double arc_length);

/// All of it [kg].
double massOf(const Cable& cable);

/// Ω₀ as the curvature of a curve through `points` [m] (a centripetal spline
/// with a rotation-minimising frame), sampled over [0, length]. The curve's own
/// length must agree with `length` within 1 %; it is scaled by the rest.
/// Throws std::invalid_argument otherwise, or for fewer than three points.
std::vector<RestCurvatureAt> restCurvatureThrough(const std::vector<Eigen::Vector3d>& points, double length);

/// Throws std::invalid_argument that names the cable, the value and the bound.
void validate(const Cable& cable);

}  // namespace cable_variation
