#pragma once

#include <functional>
#include <string>
#include <vector>

#include <Eigen/Core>

#include <cable_variation/identification/measured_points.h>

namespace cable_variation {

/// What is to be found from measured shapes.
struct IdentificationTask {
  std::vector<std::size_t> variables;  ///< unknown: indices into Scene::design_variables, one at least
  std::vector<MeasuredShape> shapes;   ///< one at least
  std::size_t most_solves = 2000;      ///< equilibria, for all shapes together
  std::function<void()> check;         ///< called before each; may throw, which ends the work
};

/// How well a shape is met.
struct ShapeFit {
  double rms = 0.0;               ///< of the points' distances from the centreline [m]
  double largest = 0.0;           ///< [m]
  std::size_t worst_point = 0;    ///< index
  std::vector<double> distances;  ///< per point [m]
};

/// Values of design variables with which the cables come closest to measured shapes.
struct Identification {
  std::vector<double> values;  ///< per unknown, in its unit, as DesignValues have it
  /// Of `values`, if distances are independent and alike, with their standard deviation taken from what is
  /// left of them, or the scene's accuracy if that is more; of what cannot be told from the points infinite.
  Eigen::VectorXd deviations;   ///< standard deviations
  Eigen::MatrixXd correlation;  ///< 0 with what cannot be told
  /// Whether the points tell its value: the standard deviation is less than half of its tolerance's width, of
  /// a variable without tolerance less than its value (of a pose, 1 rad or 1 m). What they tell less of stays
  /// at its nominal value, the least known first, and the others are found with that.
  std::vector<bool> determined;
  double noise = 0.0;          ///< standard deviation of a point, per direction normal to the cable [m]
  std::vector<ShapeFit> fits;  ///< per shape
  std::size_t solves = 0;      ///< equilibria
  bool converged = false;      ///< no step leads closer; else the solves were used up
};

/// Least squares by Levenberg's and Marquardt's method (Moré 1978, MINPACK's lmder, as Eigen has it) with the
/// exact derivatives of the shapes, from the scene's nominal values on. Shapes are followed from step to
/// step; a step to where a harness has no equilibrium is made smaller. Properties that must be positive are
/// sought by their logarithm.
/// Throws std::invalid_argument: no unknown, one twice or one that a shape says is known; no shape, a cable
/// out of range, fewer points in all than half the unknowns; as designRates() and harnessAt(); as
/// requireConverged(), naming the shape: it has no equilibrium at the nominal values.
Identification identify(const Scene& scene, const IdentificationTask& task);

/// How well a design meets shapes that had no part in finding its values, each solved anew.
/// @param values of design variables; a shape's own known ones count before them
/// Throws as identify() about shapes.
std::vector<ShapeFit> compare(const Scene& scene, const DesignValues& values,
                              const std::vector<MeasuredShape>& shapes);

}  // namespace cable_variation
