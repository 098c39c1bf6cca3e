#pragma once

#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

#include <cable_variation/equilibrium/equilibrium.h>
#include <cable_variation/measures/measure_evaluation.h>
#include <cable_variation/sensitivity/coupling.h>
#include <cable_variation/tracking/low_high.h>

namespace cable_variation {

/// A measure with one variable low, and the same variable high, the others nominal; the shape is followed
/// there, see LimitFinder.
struct LowHigh {
  double low = 0.0, high = 0.0;  ///< values of the measure; not a number: no equilibrium there
};

/// Which design variables drive which measures.
struct StabilityAnalysis {
  Equilibrium nominal;                 ///< unless it has converged the rest is empty
  std::vector<std::size_t> variables;  ///< columns, indices into Scene::design_variables
  std::vector<std::size_t> measures;   ///< rows, indices into Scene::measures
  std::vector<MeasureValue> values;    ///< per measure, at the nominal design
  Eigen::MatrixXd jacobian;            ///< [measure's unit / variable's unit]
  std::vector<bool> one_sided;         ///< per measure: the derivatives are limits from above (similarity)
  /// Per measure: why its derivatives, and all that follows from them to first order, are not defined here
  /// and not numbers in this answer, such as a value that is infinite; empty: they are.
  std::vector<std::string> undefined;
  Eigen::VectorXd variable_sigma;  ///< per variable: standard deviation [its unit]
  Eigen::VectorXd mean_shift;      ///< per measure: what means off the nominal shift it by, first order
  Eigen::VectorXd sigma;  ///< per measure: standard deviation, first order: √(J Σ Jᵀ), without correlation
                          ///< the root sum of squares of derivative times sigma
  Eigen::MatrixXd contribution;  ///< share of each variable in the variance; they add up to 1 unless it is 0
  Eigen::VectorXd worst_low,
      worst_high;  ///< per measure: smallest and largest change within the tolerances, first order
  std::vector<std::vector<LowHigh>> low_high;  ///< per measure and variable; empty unless asked for
  std::vector<double> eigenvalue_low,
      eigenvalue_high;            ///< per variable: smallest eigenvalue re-solved there [N/m]
  std::vector<SnapWithin> snaps;  ///< on the way to a low or a high: what is beyond is another equilibrium
  Coupling coupling = Coupling::coupled;
  std::vector<std::string> warnings;   ///< near a loss of stability, a snap, pairs that are not unique, ...
  std::vector<EquilibriumRate> rates;  ///< per variable: how the shape changes
  double linear_time = 0.0;            ///< for derivatives and what follows from them [s]
  double resolve_time = 0.0;           ///< for low and high [s]

  /// Of a row; empty: it is defined.
  std::string whyUndefined(std::size_t row) const { return row < undefined.size() ? undefined[row] : ""; }
};

struct StabilityOptions {
  std::vector<std::size_t> variables;  ///< indices; empty: all
  std::vector<std::size_t> measures;   ///< indices; empty: all
  DesignValues values;                 ///< the design to analyse: nominal values other than the scene's
  ComponentPoses moved;
  bool low_high = true;  ///< re-solve with each variable at its limits
};

/// Throws std::invalid_argument: an index out of range, spreadOf(), designRates().
/// @param evaluator of the scene, whatever its nominal shape: similarities are to the design analysed
/// @param solver a shape to start from, best the design's own; without one the design is solved from nothing
StabilityAnalysis analyseStability(const Scene& scene, const MeasureEvaluator& evaluator,
                                   const StabilityOptions& options, EquilibriumSolver solver);

}  // namespace cable_variation
