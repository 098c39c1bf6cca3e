#include <cmath>
#include <memory>
#include <utility>

#include <cable_variation/analysis/answer_files.h>
#include <cable_variation/analysis/design_stability.h>
#include <cable_variation/analysis/scene_loading.h>
#include <cable_variation/equilibrium/require_converged.h>
#include <cable_variation/report/stability_section.h>
#include <cable_variation/report/stability_tables.h>
#include <cable_variation/report/verdict_table.h>
#include <cable_variation/util/number_text.h>
#include <command/loaded_design.h>
#include <command/scene_options.h>
#include <command/stability_json.h>
#include <command/text_table.h>
#include <command/verb.h>

namespace cable_variation_command {

using cable_variation::MeasureEvaluator;
using cable_variation::numberText;
using cable_variation::Scene;
using cable_variation::SolvedScene;
using cable_variation::StabilityAnalysis;
using cable_variation::StabilityOptions;

namespace {

std::string textOf(const Scene& scene, const StabilityAnalysis& analysis) {
  cable_variation::MeasureEvidence evidence;
  evidence.measures = analysis.measures;
  for (const cable_variation::MeasureValue& value : analysis.values) evidence.values.push_back(value.value);
  evidence.linear = &analysis;
  std::string text = tableText(verdictTable(scene, verdictsOf(scene, evidence)));
  text +=
      "\n" + tableText(measureTable(scene, analysis)) + "\n" + tableText(sensitivityTable(scene, analysis));
  text += "\n";
  for (std::size_t i = 0; i < analysis.measures.size(); ++i) {
    const std::string& name = scene.measures[analysis.measures[i]].name;
    if (!analysis.values[i].note.empty()) text += wrapped(name + ": " + analysis.values[i].note);
    if (!analysis.whyUndefined(i).empty())
      text += wrapped(name + ": not defined: " + analysis.whyUndefined(i));
  }
  text += couplingText(analysis.coupling) + "\n";
  const double eigenvalue = analysis.nominal.smallest_eigenvalue;
  text += std::isnan(eigenvalue) ? "the smallest eigenvalue is not known where cables touch parts"
                                 : "smallest eigenvalue " + numberText(eigenvalue, 4) + " N/m";
  text += "; derivatives in " + numberText(1e3 * analysis.linear_time, 3) + " ms";
  if (!analysis.low_high.empty())
    text += ", low and high in " + numberText(1e3 * analysis.resolve_time, 3) + " ms";
  return text + "\n";
}

class StabilityVerb : public Verb {
 public:
  void declare(Options& options) override {
    scene_.declare(options);
    options.texts("variables", "NAME", request_.variables, "columns; default: all of the scene");
    options.texts("measures", "NAME", request_.measures, "rows; default: all of the scene");
    values_.declare("nominal_variables", "nominal_values", options);
    options.flag("skip_low_high", request_.skip_low_high, "leave out the solves at low and high");
    options.text("report", "NAME", request_.report, "write NAME.csv and NAME.html");
    files_.declare(options);
  }

  Answer run(cable_variation::RunControl& control) override {
    if (!request_.report.empty()) cable_variation::OutputDirectory::checkName(request_.report);
    LoadedDesign design(scene_.load(control), files_.author);
    const Scene& scene = design.scene();
    values_.resolve(scene, request_.nominal_variables, request_.nominal_values);
    StabilityOptions options = toStabilityOptions(request_, scene);
    control.report({"analysing"});
    const auto prepared = [&](const SolvedScene& any) -> const MeasureEvaluator& {
      return design.evaluator(any);
    };
    const StabilityAnalysis analysis =
        analyseDesign(design.design(), {}, design.equilibrium(), design.solver(), prepared, options);
    requireConverged(analysis.nominal);

    Answer answer;
    answer.json = stabilityJson(scene, options, analysis, componentVariations(scene, options));
    answer.text = textOf(scene, analysis);
    answer.warnings = warningsOf(scene);
    answer.warnings.insert(answer.warnings.end(), analysis.warnings.begin(), analysis.warnings.end());
    control.complete();
    write(design, options, analysis, answer);
    return answer;
  }

 private:
  void write(const LoadedDesign& design, const StabilityOptions& options, const StabilityAnalysis& analysis,
             Answer& answer) const {
    std::string csv, page;
    if (!request_.report.empty()) {
      const Scene& scene = design.scene();
      const cable_variation::OutputDirectory output = files_.output();
      std::string& error = answer.status.message;
      page = writeBeside(output, request_.report, ".html",
                         stabilityPage(design.origin(), scene, analysis, options), error);
      csv =
          writeBeside(output, request_.report, ".csv", stabilityCsv(scene, analysis, options.values), error);
      if (!error.empty()) answer.status.code = cable_variation::StatusCode::io_error;
    }
    answer.json.set("csv_file", csv).set("report_file", page);
    for (const std::string& file : {csv, page}) answer.text += file.empty() ? "" : file + "\n";
  }

  SceneOption scene_;
  ValueOptions values_;
  FileOptions files_;
  cable_variation::StabilityRequest request_;
};

}  // namespace

std::unique_ptr<Verb> makeStability() { return std::make_unique<StabilityVerb>(); }

}  // namespace cable_variation_command
