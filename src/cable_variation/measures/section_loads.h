#pragma once

#include <cable_variation/measures/cable_view.h>

namespace cable_variation {

/// Section force and moment at a point of a shape, with two derivatives over s,
/// all in the section's frame: by the balance of force and moment,
/// n' = -Ω×n - ρA Rᵀg and m' = -Ω×m - Γ×n, and these differentiated once more.
struct PointLoads {
  Eigen::Vector3d force, force_slope, force_second;     ///< [N], [N/m], [N/m²]
  Eigen::Vector3d moment, moment_slope, moment_second;  ///< [N m], [N], [N/m]
};

/// The loads between two neighbouring points of a shape: quintic polynomials
/// that meet the points' loads and their derivatives (sixth order in the distance of the points).
class SectionLoads {
 public:
  SectionLoads(const CableView& view, std::size_t piece, const Eigen::Vector3d& gravity);

  Eigen::Vector3d force(double t) const { return force_.position(t); }      ///< [N]
  Eigen::Vector3d moment(double t) const { return moment_.position(t); }    ///< [N m]
  Eigen::Vector3d forceSlope(double t) const { return force_.first(t); }    ///< over t [N]
  Eigen::Vector3d momentSlope(double t) const { return moment_.first(t); }  ///< over t [N m]
  Eigen::Matrix<double, 6, 1> stiffness(double t) const {                   ///< EA GA_y GA_z GJ EI_y EI_z
    return (1.0 - t) * stiffness_start_ + t * stiffness_end_;
  }

  /// First-order change at fixed t.
  struct Rate;
  Rate rate(const CableRates& rates) const;

 private:
  // A point's loads, and what their changes need.
  struct End : PointLoads {
    Eigen::Matrix3d to_section;
    Eigen::Vector3d pull;  ///< Rᵀg
    Eigen::Vector3d strain, curvature, gamma, omega;
    Eigen::Vector3d gamma_slope, omega_slope, curvature_slope;
    double arc_length;
  };
  static End loadsAt(const ShapePoint& point, const RodProperties& rod, const Eigen::Vector3d& gravity);
  static PointLoads loadRates(const End& end, const RodProperties& rod, const RodProperties& rod_rate,
                              const ShapePointRate& rate);

  std::size_t point_;
  double length_;
  RodProperties rod_start_, rod_end_;
  Eigen::Matrix<double, 6, 1> stiffness_start_, stiffness_end_;
  End start_, end_;
  CurvePiece force_, moment_;
};

struct SectionLoads::Rate {
  Eigen::Vector3d force(double t) const { return forceCurve().position(t); }    ///< [N]
  Eigen::Vector3d moment(double t) const { return momentCurve().position(t); }  ///< [N m]
  CurvePiece forceCurve() const;
  CurvePiece momentCurve() const;
  Eigen::Matrix<double, 6, 1> stiffness(double t) const {
    return (1.0 - t) * stiffness_start + t * stiffness_end;
  }

  double length = 0.0;  ///< of the piece [m]
  /// Of the loads at the points. Slopes are over s of the piece as it was.
  PointLoads start, end;
  Eigen::Matrix<double, 6, 1> stiffness_start, stiffness_end;
  double piece_length = 0.0;  ///< before the change [m]
};

}  // namespace cable_variation
