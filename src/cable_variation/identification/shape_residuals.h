#pragma once  // internal to identification/

#include <vector>

#include <Eigen/Core>

#include <cable_variation/equilibrium/equilibrium.h>
#include <cable_variation/identification/measured_points.h>

namespace cable_variation {

/// How far measured points are from a solved cable: per point the vector from the nearest place of its
/// centreline, seen in two directions normal to the centreline and the one along it, which is 0 but at the
/// cable's ends. Its square is that of the distance.
struct ShapeResiduals {
  Eigen::VectorXd values;  ///< three per point [m]
  Eigen::MatrixXd rates;   ///< rows as `values`, a column per variable; empty without rates
};

/// The places are found in order along the cable: the first is that nearest to the first point, each further
/// one is looked for where the points have come along, so that a loop which crosses itself is no riddle.
/// @param rates of the equilibrium, one per variable; may be none
ShapeResiduals shapeResiduals(const Harness& harness, const Equilibrium& equilibrium,
                              const MeasuredShape& measured, const std::vector<EquilibriumRate>& rates);

}  // namespace cable_variation
