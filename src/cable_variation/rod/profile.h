#pragma once

#include <vector>

#include <Eigen/Core>

#include <cable_variation/rod/cable.h>

namespace cable_variation {

/// What the rod is at one arc length, with derivatives over arc length.
struct RodProperties {
  Eigen::Matrix<double, 6, 1> stiffness;        ///< EA GA_y GA_z [N], GJ EI_y EI_z [N m²]
  Eigen::Matrix<double, 6, 1> stiffness_slope;  ///< [N/m], [N m]
  Eigen::Vector3d rest_curvature;               ///< Ω₀ [1/m]
  Eigen::Vector3d rest_curvature_slope;         ///< [1/m²]
  Eigen::Vector3d rest_curvature_second;        ///< [1/m³]
  double mass_per_length;                       ///< [kg/m]
  double mass_slope;                            ///< [kg/m²]
  double radius;                                ///< [m]
};

/// A cable's properties along its arc length: sections piecewise linear, rest
/// curvature by cubic Hermite pieces with finite-difference slopes (continuously
/// differentiable except where two knots share an arc length).
class RodProfile {
 public:
  /// `cable` must be valid (see validate()).
  explicit RodProfile(const Cable& cable);

  /// At a step of the section, the side s+ counts.
  RodProperties at(double arc_length) const;

  /// Arc lengths strictly inside the cable where the grid must have a
  /// boundary: section knots and steps of the rest curvature.
  std::vector<double> breaks() const;

 private:
  struct CurvatureKnot {
    double arc_length;
    Eigen::Vector3d value, slope_before, slope_after;
  };

  double length_;
  std::vector<SectionAt> sections_;
  std::vector<CurvatureKnot> curvature_;
};

}  // namespace cable_variation
