#include <cable_variation/analysis/envelope_report.h>

#include <sstream>

#include <cable_variation/equilibrium/require_converged.h>
#include <cable_variation/report/review.h>
#include <cable_variation/report/share_text.h>
#include <cable_variation/util/chosen_indices.h>
#include <cable_variation/analysis/review_start.h>

namespace cable_variation {

namespace {

std::vector<ReportFact> about(const Scene& scene, const EnvelopeFindings& found) {
  const std::string held = found.envelope.probability > 0.0
                               ? shareText(found.envelope.probability) + " of production"
                               : "all that the tolerances allow at their worst together";
  std::vector<ReportFact> facts{{"Envelope of", held}};
  if (found.options.motions.empty()) return facts;
  std::ostringstream over;
  over << motionText(scene, found.options.motions) << ", " << found.envelope.phases.front().start << " s to "
       << found.envelope.phases.back().end << " s";
  facts.push_back({"Motion", over.str()});
  return facts;
}

}  // namespace

std::string envelopeReport(const EnvelopeTask& task, const DesignSnapshot& snapshot,
                           const EquilibriumSolver& solver, const EnvelopeFindings& found,
                           const std::vector<std::string>& warnings) {
  const Scene& scene = snapshot.design.scene;
  const SolvedSample design =
      solveSample(scene, task.options, found.envelope, found.envelope.samples.front(), solver);
  requireConverged(design.equilibrium);
  const SolvedScene solved{design.harness, design.equilibrium, design.components};
  Review review = startReview("Tolerance envelope", snapshot.origin, scene, task.options.values, solved);
  review.about = about(scene, found);
  review.warnings.insert(review.warnings.end(), warnings.begin(), warnings.end());
  review.measures = allIndices(scene.measures.size());
  review.measured = MeasureEvaluator(scene, solved).evaluate(solved, review.measures);
  review.variables = found.envelope.variables;
  review.envelope.emplace(found);
  return reviewPage(review);
}

}  // namespace cable_variation
