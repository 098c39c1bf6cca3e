#include <cable_variation/analysis/design_trial.h>

#include <limits>
#include <sstream>
#include <stdexcept>

#include <cable_variation/analysis/name_lookup.h>
#include <cable_variation/analysis/review_start.h>
#include <cable_variation/equilibrium/require_converged.h>
#include <cable_variation/measures/open_parts.h>
#include <cable_variation/scene/measure_traits.h>
#include <cable_variation/scene/moving_components.h>
#include <cable_variation/util/chosen_indices.h>
#include <cable_variation/util/quantity.h>

namespace cable_variation {

DesignTrial solveTrial(const Design& design, const DesignValues& values, const ComponentPoses& moved,
                       const EquilibriumSolver* follow) {
  DesignTrial trial;
  trial.harness = harnessAt(design, values, moved);
  EquilibriumSolver solver = follow != nullptr ? *follow : newSolver(design.scene);
  trial.equilibrium = follow != nullptr ? solver.update(trial.harness) : solver.solve(trial.harness);
  requireConverged(trial.equilibrium);
  DesignValues all = values;
  all.insert(design.shifted.begin(), design.shifted.end());
  trial.components = componentPosesAt(design.scene, all, moved);
  return trial;
}

ComponentPoses placesDuring(const Design& design, const std::string& name, double time) {
  const Scene& scene = design.scene;
  const Motion& motion = scene.motions[indexOf(name, scene.motions, "motion")];
  if (!(time >= 0.0 && time <= motion.duration())) {
    std::ostringstream text;
    text << "motion '" << name << "': time " << time << " s, expected 0 to " << motion.duration() << " s";
    throw std::invalid_argument(text.str());
  }
  return placesOf(design, posesDuring(scene, {&motion}, time));
}

std::vector<MeasureValue> measureTrial(const Scene& scene, const MeasureEvaluator& evaluator,
                                       bool has_nominal, const SolvedScene& at,
                                       const std::vector<std::size_t>& measures) {
  if (has_nominal) return evaluator.evaluate(at, measures);
  std::vector<MeasureValue> values = evaluator.with(scene, at).evaluate(at, measures);
  for (std::size_t i = 0; i < measures.size(); ++i) {
    if (!traitsOf(scene.measures[measures[i]].type).from_nominal) continue;
    values[i] = MeasureValue();
    values[i].value = std::numeric_limits<double>::quiet_NaN();
    values[i].note = "the design in force has no equilibrium to compare with";
  }
  return values;
}

std::string equilibriumPage(const EquilibriumRequest& request, const DesignOrigin& origin,
                            const Design& design, const DesignValues& values, const DesignTrial& trial,
                            const std::vector<MeasureValue>& measured, const ComponentParts& parts) {
  const Scene& scene = design.scene;
  DesignValues all = values;
  all.insert(design.shifted.begin(), design.shifted.end());
  const SolvedScene solved{trial.harness, trial.equilibrium, trial.components};
  Review review = startReview("Equilibrium", origin, scene, all, solved);
  if (!request.motion.empty())
    review.about = {{"Motion", request.motion + " at " + shortNumber(request.time) + " s"}};
  review.measures = allIndices(scene.measures.size());
  for (std::string& warning : openPartWarnings(scene, parts, componentsMeasured(scene, review.measures)))
    review.warnings.push_back(std::move(warning));
  review.measured = measured;
  return reviewPage(review);
}

}  // namespace cable_variation
