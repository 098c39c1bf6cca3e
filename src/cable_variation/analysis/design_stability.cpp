#include <cable_variation/analysis/design_stability.h>

#include <utility>

#include <cable_variation/analysis/design_values.h>
#include <cable_variation/analysis/name_lookup.h>
#include <cable_variation/analysis/review_start.h>
#include <cable_variation/equilibrium/require_converged.h>

namespace cable_variation {

StabilityOptions toStabilityOptions(const StabilityRequest& request, const Scene& scene) {
  StabilityOptions options;
  options.variables = indicesOf(request.variables, scene.design_variables, "design variable");
  options.measures = indicesOf(request.measures, scene.measures, "measure");
  options.values = toDesignValues(scene, request.nominal_variables, request.nominal_values);
  options.low_high = !request.skip_low_high;
  return options;
}

StabilityAnalysis analyseDesign(const Design& design, const ComponentPoses& moved,
                                const Equilibrium& in_force, EquilibriumSolver solver,
                                const std::function<const MeasureEvaluator&(const SolvedScene&)>& prepared,
                                StabilityOptions& options) {
  const Harness harness = harnessAt(design, options.values, moved);
  Equilibrium equilibrium = options.values.empty() ? in_force : solver.update(harness);
  if (!equilibrium.converged() && !options.values.empty()) equilibrium = solver.solve(harness);
  requireConverged(equilibrium);
  options.values.insert(design.shifted.begin(), design.shifted.end());
  options.moved = moved;
  const ComponentPoses components = componentPosesAt(design.scene, options.values, moved);
  const MeasureEvaluator& evaluator = prepared({harness, equilibrium, components});
  return analyseStability(design.scene, evaluator, options, std::move(solver));
}

std::vector<ComponentVariation> componentVariations(const Scene& scene, const StabilityOptions& options) {
  std::vector<ComponentVariation> variations;
  for (std::size_t i = 0; i < scene.components.size(); ++i) {
    const std::vector<std::size_t> own = ownVariables(scene, i);
    if (own.empty()) continue;
    variations.push_back(componentVariation(scene, i, own, options.values, options.moved));
  }
  return variations;
}

std::string stabilityPage(const DesignOrigin& origin, const Scene& scene, const StabilityAnalysis& analysis,
                          const StabilityOptions& options) {
  const Harness harness = harnessAt(scene, options.values, options.moved);
  const ComponentPoses poses = componentPosesAt(scene, options.values, options.moved);
  const SolvedScene solved{harness, analysis.nominal, poses};
  Review review = startReview("Stability analysis", origin, scene, options.values, solved);
  review.measures = analysis.measures;
  review.measured = analysis.values;
  review.variables = analysis.variables;
  review.stability = &analysis;
  return reviewPage(review);
}

}  // namespace cable_variation
