#pragma once

#include <string>
#include <utility>

#include <cable_variation/equilibrium/equilibrium.h>
#include <hunt/discrete_rod.h>

namespace cable_variation::hunt {

/// The independent rod, settled from an answer on two grids, and extrapolated from both (Richardson: its
/// error is of second order).
struct Settled {
  explicit Settled(DiscreteRod on) : rod(std::move(on)) {}

  DiscreteRod rod;          ///< on the coarser grid
  DiscreteShape shape;      ///< likewise
  bool decided = false;     ///< both grids settled, near each other; else nothing below is set
  std::string text;         ///< why not
  double off = 0.0;         ///< largest distance of the answer's centreline from the extrapolated one [m]
  double grids = 0.0;       ///< between the two grids [m]
  double eigenvalue = 0.0;  ///< smallest, extrapolated [N/m]
  double eigenvalue_coarse = 0.0;   ///< on the coarser grid
  double eigenvalue_unclear = 0.0;  ///< what neutral motions and rounding leave of it [N/m]

  bool centrelineIsOff(double accuracy) const { return decided && off > 2.0 * accuracy + 0.3 * grids; }
  /// Clear of the grids' own error.
  bool isSaddle() const {
    return decided && eigenvalue < -eigenvalue_unclear && eigenvalue_coarse < 0.5 * eigenvalue;
  }
  /// A reported eigenvalue that is not this one.
  bool eigenvalueIsOff(double reported) const;
};

/// `segments` per cable on the coarser grid.
Settled settleFrom(const Harness& harness, const Equilibrium& answer, std::size_t segments);

}  // namespace cable_variation::hunt
