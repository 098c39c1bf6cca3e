#include <cmath>
#include <memory>
#include <utility>

#include <cable_variation/analysis/answer_files.h>
#include <cable_variation/analysis/design_trial.h>
#include <cable_variation/analysis/design_values.h>
#include <cable_variation/analysis/scene_loading.h>
#include <cable_variation/equilibrium/require_converged.h>
#include <cable_variation/measures/open_parts.h>
#include <cable_variation/report/equilibrium_section.h>
#include <cable_variation/report/route_table.h>
#include <cable_variation/report/verdict_table.h>
#include <cable_variation/util/chosen_indices.h>
#include <cable_variation/util/number_text.h>
#include <command/equilibrium_json.h>
#include <command/loaded_design.h>
#include <command/scene_json.h>
#include <command/scene_options.h>
#include <command/text_table.h>
#include <command/verb.h>

namespace cable_variation_command {

using cable_variation::ComponentPoses;
using cable_variation::DesignTrial;
using cable_variation::DesignValues;
using cable_variation::Equilibrium;
using cable_variation::MeasureValue;
using cable_variation::numberText;
using cable_variation::Scene;
using cable_variation::SolvedScene;

namespace {

std::string figuresText(const Equilibrium& found) {
  const std::string eigenvalue =
      std::isnan(found.smallest_eigenvalue)
          ? "stable; the smallest eigenvalue is not known where cables touch parts"
          : "smallest eigenvalue " + numberText(found.smallest_eigenvalue, 4) +
                (found.smallest_eigenvalue > 0.0 ? " N/m (above 0: stable)" : " N/m");
  std::string text = eigenvalue + "; other stable shapes found: " + std::to_string(found.alternatives.size());
  text += "\n" + std::to_string(found.iterations) + " iterations, residual " + numberText(found.residual, 2) +
          " N, estimated error " + numberText(1e3 * found.discretisation_error, 2) + " mm, solved in " +
          numberText(1e3 * found.solve_time, 3) + " ms\n";
  return text;
}

std::string measuresText(const Scene& scene, const std::vector<MeasureValue>& measured) {
  if (measured.empty()) return "";
  const std::vector<std::size_t> all = cable_variation::allIndices(scene.measures.size());
  cable_variation::MeasureEvidence evidence;
  evidence.measures = withoutPlainRoutes(scene, all);
  for (const std::size_t index : evidence.measures) evidence.values.push_back(measured[index].value);
  std::string text;
  const cable_variation::ReportTable routes = routeTable(scene, all, measured);
  if (!routes.rows.empty()) text += "\n" + tableText(routes);
  if (!evidence.measures.empty())
    text += "\n" + tableText(verdictTable(scene, verdictsOf(scene, evidence), "value"));
  for (std::size_t i = 0; i < measured.size(); ++i) {
    if (!measured[i].note.empty()) text += wrapped(scene.measures[i].name + ": " + measured[i].note);
  }
  return text;
}

// The design itself is solved already.
DesignTrial trialOf(const LoadedDesign& design) {
  requireConverged(design.equilibrium());
  return {design.harness(), design.equilibrium(), design.solved().components};
}

class SolveVerb : public Verb {
 public:
  void declare(Options& options) override {
    scene_.declare(options);
    values_.declare("variables", "values", options);
    declareMotion(request_.motion, request_.time, options);
    options.flag("follow", request_.follow,
                 "follow the design's own shape to the values, do not look for the lowest");
    options.text("report", "NAME", request_.report, "write NAME.html");
    files_.declare(options);
  }

  Answer run(cable_variation::RunControl& control) override {
    if (!request_.report.empty()) cable_variation::OutputDirectory::checkName(request_.report);
    LoadedDesign design(scene_.load(control), files_.author);
    const Scene& scene = design.scene();
    values_.resolve(scene, request_.variables, request_.values);
    const DesignValues values = toDesignValues(scene, request_.variables, request_.values);
    const ComponentPoses moved = placesAt(design.design(), request_.motion, request_.time);
    control.report({"solving"});
    const DesignTrial trial =
        values.empty() && moved.empty()
            ? trialOf(design)
            : solveTrial(design.design(), values, moved, request_.follow ? &design.solver() : nullptr);
    return answer(design, trial, values, control);
  }

 private:
  Answer answer(LoadedDesign& design, const DesignTrial& trial, const DesignValues& values,
                cable_variation::RunControl& control) const {
    const Scene& scene = design.scene();
    const SolvedScene solved{trial.harness, trial.equilibrium, trial.components};
    const std::vector<std::size_t> all = cable_variation::allIndices(scene.measures.size());
    const std::vector<MeasureValue> measured =
        measureTrial(scene, design.evaluator(solved), design.equilibrium().converged(), solved, all);
    std::vector<std::string> warnings = trial.equilibrium.notes;
    for (std::string& warning : openPartWarnings(scene, design.parts(), componentsMeasured(scene, all)))
      warnings.push_back(std::move(warning));

    Answer answer;
    answer.json = equilibriumJson(trial.equilibrium, trial.harness);
    Json measures = Json::array();
    for (const std::size_t i : all) measures.add(measureJson(scene.measures[i], measured[i], scene));
    answer.json.set("measures", std::move(measures)).set("warnings", warnings);
    answer.warnings = warningsOf(scene);
    answer.warnings.insert(answer.warnings.end(), warnings.begin(), warnings.end());
    for (const cable_variation::ReportTable& table : equilibriumTables(solved))
      answer.text += tableText(table) + "\n";
    answer.text += figuresText(trial.equilibrium) + measuresText(scene, measured);
    control.complete();
    std::string report;
    if (!request_.report.empty()) {
      const std::string page = equilibriumPage(request_, design.origin(), design.design(), values, trial,
                                               measured, design.parts());
      report = writeBeside(files_.output(), request_.report, ".html", page, answer.status.message);
      if (report.empty()) answer.status.code = cable_variation::StatusCode::io_error;
      if (!report.empty()) answer.text += report + "\n";
    }
    answer.json.set("report_file", report);
    return answer;
  }

  SceneOption scene_;
  ValueOptions values_;
  FileOptions files_;
  cable_variation::EquilibriumRequest request_;
};

}  // namespace

std::unique_ptr<Verb> makeSolve() { return std::make_unique<SolveVerb>(); }

}  // namespace cable_variation_command
