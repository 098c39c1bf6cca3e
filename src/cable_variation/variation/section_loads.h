#pragma once

#include <cable_variation/variation/cable_view.h>

namespace cable_variation {

/// Section force and moment, in the section's frame, between two neighbouring
/// points of a shape: quintic polynomials that meet the points' values and, by
/// the balance of force and moment, their first and second derivatives over s
/// (sixth order in the distance of the points).
class SectionLoads {
 public:
  SectionLoads(const CableView& view, std::size_t piece, const Eigen::Vector3d& gravity);

  Eigen::Vector3d force(double t) const { return force_.position(t); }      ///< [N]
  Eigen::Vector3d moment(double t) const { return moment_.position(t); }    ///< [N m]
  Eigen::Vector3d forceSlope(double t) const { return force_.first(t); }    ///< over t [N]
  Eigen::Vector3d momentSlope(double t) const { return moment_.first(t); }  ///< over t [N m]
  Eigen::Matrix<double, 6, 1> stiffness(double t) const;                    ///< EA GA_y GA_z GJ EI_y EI_z

  /// Change of force, moment and stiffness at a fixed t, as an object of the same kind.
  static SectionLoads rate(const CableView& view, std::size_t piece, const Eigen::Vector3d& gravity,
                           const CableRates& rates) {
    return ratesAlong(view, piece, piece, gravity, rates).front();
  }
  /// Of the pieces from `first` to `last`.
  static std::vector<SectionLoads> ratesAlong(const CableView& view, std::size_t first, std::size_t last,
                                              const Eigen::Vector3d& gravity, const CableRates& rates);

 private:
  SectionLoads(const CurvePiece& force, const CurvePiece& moment) : force_(force), moment_(moment) {}

  CurvePiece force_, moment_;
  Eigen::Matrix<double, 6, 1> stiffness_start_ = Eigen::Matrix<double, 6, 1>::Zero();
  Eigen::Matrix<double, 6, 1> stiffness_end_ = Eigen::Matrix<double, 6, 1>::Zero();
};

}  // namespace cable_variation
