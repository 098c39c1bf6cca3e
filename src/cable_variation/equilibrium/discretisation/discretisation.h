#pragma once  // internal to equilibrium/

#include <vector>

#include <cable_variation/equilibrium/discretisation/rod_system.h>

namespace cable_variation {

/// How far the discrete equilibrium is from the continuum's.
struct DiscretisationError {
  NodalField step;          ///< from the fine grid's equilibrium to the coarse one's
  double centreline = 0.0;  ///< estimate of the largest distance [m]
  /// Per cable: estimate for the forces and moments at the ends of its spans, over the largest in it, and for
  /// the directions of its sections' normals over kDirections [rad]; what EquilibriumOptions::force_accuracy
  /// is for.
  std::vector<double> force;
  std::vector<std::vector<double>>
      contribution;  ///< per span and pair of elements: energy the pair's halves differ by [J]
};

/// What the directions of sections are measured over where forces are over the largest [rad].
constexpr double kDirections = 5.0;

/// The error of a grid whose equilibrium differs by `difference` [m] from that with every pair of elements
/// merged, on cables of `length` [m]: what a method of the order that can be counted on leaves.
double errorOfFiner(double difference, double length);

/// Of the forces or the moments at the ends of a cable: what refining may still change them by, over the
/// largest in the cable. Two grids differ by `difference`, one with every pair of elements merged. `least`:
/// what is smaller counts as none.
double endForceError(double difference, double largest, double least);

/// The moment that counts as none in a cable of bending stiffness EI [N m²]: what bends it by a hundredth of
/// a radian along its length. Over the length: the force.
double negligibleMoment(double bending_stiffness, double length);

/// Compares the equilibrium of `fine`, also given as `on_coarse`, with that of `coarse`,
/// the same harness on the grid with every pair of elements merged: a Newton
/// step there with the section forces of `fine`, at every node, inner ones too, since shapes are read between
/// the elements' ends as well. A method of order p leaves the fine grid an error of 1/(2^p - 1) of the
/// difference. The ends converge with order 6 and what lies between with order 4 once the grid resolves the
/// shape, less where a rest curvature is given by knots; reported is a third of a large difference (order 2)
/// and a seventh of a small one (order 3). `fine` must hold the energies at its equilibrium; its stresses are
/// held. When that is `stable` but not so on the coarse grid, the error is infinite: the grid says too little
/// about it.
DiscretisationError estimateDiscretisation(RodSystem& fine, RodSystem& coarse, const Configuration& on_coarse,
                                           bool stable = true);

}  // namespace cable_variation
