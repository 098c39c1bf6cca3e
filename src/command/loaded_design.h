#pragma once

#include <memory>
#include <optional>
#include <string>

#include <cable_variation/analysis/design_snapshot.h>
#include <cable_variation/analysis/design_trial.h>
#include <cable_variation/measures/measure_evaluation.h>

namespace cable_variation_command {

/// A scene and its shape, solved from nothing: what the solver's node has of it before anybody has changed
/// anything. Not to be moved: what is made of it refers to it.
class LoadedDesign {
 public:
  /// The harness need not have an equilibrium. @param author of reports
  explicit LoadedDesign(cable_variation::Scene scene, const std::string& author = "");
  LoadedDesign(const LoadedDesign&) = delete;
  LoadedDesign& operator=(const LoadedDesign&) = delete;

  const cable_variation::Design& design() const { return design_; }
  const cable_variation::Scene& scene() const { return design_.scene; }
  const cable_variation::Harness& harness() const { return harness_; }
  const cable_variation::Equilibrium& equilibrium() const { return equilibrium_; }
  const cable_variation::EquilibriumSolver& solver() const { return solver_; }
  const cable_variation::DesignOrigin& origin() const { return origin_; }

  /// The design's own shape, converged or not.
  cable_variation::SolvedScene solved() const { return {harness_, equilibrium_, components_}; }

  /// An evaluator of the scene, made when it is first asked for. Its nominal shape is the design's, if that
  /// has an equilibrium, else `any`.
  const cable_variation::MeasureEvaluator& evaluator(const cable_variation::SolvedScene& any);
  /// Components as far as measures have looked at them.
  cable_variation::ComponentParts parts() const;

  cable_variation::DesignSnapshot snapshot() const;

 private:
  cable_variation::Design design_;
  cable_variation::DesignOrigin origin_;
  cable_variation::Harness harness_;
  cable_variation::EquilibriumSolver solver_;
  cable_variation::Equilibrium equilibrium_;
  cable_variation::ComponentPoses components_;
  std::optional<cable_variation::MeasureEvaluator> evaluator_;
};

}  // namespace cable_variation_command
