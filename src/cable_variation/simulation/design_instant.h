#pragma once  // internal to simulation/

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include <Eigen/Core>

#include <cable_variation/equilibrium/batch_solver.h>
#include <cable_variation/measures/measure_evaluation.h>
#include <cable_variation/sensitivity/stability_analysis.h>
#include <cable_variation/simulation/simulation_statistics.h>
#include <cable_variation/tracking/shape_follower.h>

namespace cable_variation {

/// The design at one time of a simulation, ready for samples around it. const: may be shared by threads.
class DesignInstant {
 public:
  /// @param space of scene, variables, motions; must outlive it, as must `scene`
  /// @param measures indices @param solver a shape to start from
  /// Throws as requireConverged(): no equilibrium; std::invalid_argument: analyseStability().
  DesignInstant(const SampleSpace& space, const VariedDesign& design,
                const std::vector<std::size_t>& measures, const MeasureEvaluator& evaluator,
                std::size_t sections, const EquilibriumSolver& solver, double time);
  DesignInstant(const DesignInstant&) = delete;
  DesignInstant& operator=(const DesignInstant&) = delete;

  double time() const { return time_; }
  const Harness& harness() const { return harness_; }
  const EquilibriumSolver& solver() const { return solver_; }  ///< follows the design's shape here
  const StabilityAnalysis& linear() const { return linear_; }
  /// What the linear model predicts of the measures; not a number where it cannot: a similarity has a kink.
  void predict(const double* deviations, double* values) const;
  /// Its exact mean and standard deviation, per measure.
  std::vector<std::optional<LinearMoments>> linearMoments() const;

  /// Of the design, at a cable's sections [m].
  std::vector<double> arcLengths(std::size_t cable) const;
  /// Along which the sections of a cable vary most, by the linear model: columns, unit vectors.
  const std::vector<Eigen::Matrix3d>& axes(std::size_t cable) const { return axes_[cable]; }

 private:
  friend class InstantSolver;
  bool isDoubtful(const SamplePlace& place) const;  // it may be beyond a snap
  void findAxes(const std::vector<CableView>& views, const std::vector<std::size_t>& variables);
  /// Whether the cables snap on the way to where one variable is at its rarest values, or all go where a
  /// section moves most.
  bool snapsNearby(const std::vector<std::size_t>& variables) const;

  const SampleSpace* space_;
  double time_;
  std::vector<std::size_t> measures_;
  bool eigenvalue_;             // is among them
  std::vector<double> shares_;  // of a cable's length
  Harness harness_;
  StabilityAnalysis linear_;
  EquilibriumSolver solver_;
  ComponentPoses components_;
  MeasureEvaluator evaluator_;
  std::vector<std::vector<Eigen::Matrix3d>> axes_;  // per cable and section
  Eigen::VectorXd furthest_;                        // along the axis of that section: gradient, per variable
  double largest_sigma_ = 0.0;                      // of a section, by the linear model [m]
  std::vector<MaterialStretch> stretches_;
  std::vector<std::string> frames_ = {"world"};
  StretchReader reader_;
  std::optional<ShapeFollower> follower_;
  bool watchful_ = false;             // somewhere that production goes the cables snap
  std::optional<BatchSolver> batch_;  // none: it cannot take this harness
};

/// One sample's equilibrium and what was found in it; without one the figures mean nothing.
struct SampleSolution {
  SampleOutcome outcome = SampleOutcome::not_converged;
  bool solved_again = false;             ///< by the robust solver
  bool undecided = false;                ///< whether a cable is inside of an open part
  double discretisation_error = 0.0;     ///< [m]
  std::vector<double> values;            ///< per measure
  std::vector<Eigen::Matrix3Xd> points;  ///< per cable, of its sections [m, world]
};

/// Solves samples around a DesignInstant, some at a time. One per thread.
class InstantSolver {
 public:
  static constexpr std::size_t kSamples = BatchSolver::kBatch;

  /// @param instant must outlive the worker
  explicit InstantSolver(const DesignInstant& instant);

  /// @param deviations one column per sample, at most kSamples
  const std::array<SampleSolution, kSamples>& solve(const Eigen::MatrixXd& deviations);

 private:
  void solveRobustly(const SamplePlace& place, SampleSolution& sample);
  void read(const SamplePlace& place, const Harness& harness, const Equilibrium& equilibrium,
            SampleSolution& sample);

  const DesignInstant* instant_;
  std::optional<BatchSolver> batch_;
  std::vector<Harness> harnesses_;
  std::array<SampleSolution, kSamples> samples_;
};

}  // namespace cable_variation
