#include <algorithm>
#include <memory>
#include <optional>
#include <utility>

#include <cable_variation/analysis/answer_files.h>
#include <cable_variation/analysis/design_stability.h>
#include <cable_variation/analysis/envelope_calculation.h>
#include <cable_variation/analysis/review_start.h>
#include <cable_variation/analysis/scene_loading.h>
#include <cable_variation/analysis/simulation_task.h>
#include <cable_variation/equilibrium/require_converged.h>
#include <cable_variation/report/review.h>
#include <cable_variation/report/summary_section.h>
#include <cable_variation/report/verdict_table.h>
#include <cable_variation/util/error.h>
#include <cable_variation/util/name_list.h>
#include <command/loaded_design.h>
#include <command/scene_options.h>
#include <command/text_table.h>
#include <command/verb.h>

namespace cable_variation_command {

using cable_variation::EnvelopeCalculation;
using cable_variation::EnvelopeRequest;
using cable_variation::EnvelopeTask;
using cable_variation::MeasureEvaluator;
using cable_variation::MeasureVerdict;
using cable_variation::Review;
using cable_variation::Scene;
using cable_variation::Simulation;
using cable_variation::SimulationRequest;
using cable_variation::SolvedScene;
using cable_variation::StabilityAnalysis;
using cable_variation::StabilityOptions;

namespace {

/// Analyses that are optional, as words of --chapters.
const std::vector<std::string>& chapterNames() {
  static const std::vector<std::string> kNames{"simulation", "envelope", "none"};
  return kNames;
}

Json verdictsJson(const Scene& scene, const std::vector<MeasureVerdict>& verdicts) {
  Json list = Json::array();
  for (const MeasureVerdict& each : verdicts) {
    Json json = Json::object();
    json.set("name", scene.measures[each.measure].name).set("verdict", toString(each.verdict));
    json.set("basis", each.basis).set("value", each.value).set("sigma", each.sigma).set("cpk", each.cpk);
    json.set("worst_low", each.worst_low).set("worst_high", each.worst_high);
    list.add(json.set("outside", each.outside));
  }
  return list;
}

class ReportVerb : public Verb {
 public:
  void declare(Options& options) override {
    scene_.declare(options);
    options.text("report", "NAME", report_, "write NAME.html; default: report");
    options.texts(
        "chapters", "NAME", chapters_,
        "beside the design at rest and its stability analysis: simulation, envelope or none; default: both");
    values_.declare("nominal_variables", "nominal_values", options);
    options.texts("variables", "NAME", variables_, "that vary within their tolerances; default: all");
    options.count("samples", "COUNT", simulation_.samples, "of the simulation; default: 10,000");
    options.text("sampler", "NAME", simulation_.sampler, "monte_carlo, latin_hypercube or sobol");
    options.number("probability", "SHARE", "1", envelope_.probability,
                   "of production that the envelope is to hold; default: the worst case");
    options.count("seed", "NUMBER", seed_, "of samples and of random shapes; default: 1");
    options.flag("skip_low_high", skip_low_high_, "leave out the solves at low and high");
    files_.declare(options);
    limits_.declare(options);
  }

  Answer run(cable_variation::RunControl& control) override {
    cable_variation::OutputDirectory::checkName(report_);
    checkChapters();
    files_.output().requireWritable();
    LoadedDesign design(scene_.load(control), files_.author);
    const Scene& scene = design.scene();
    std::vector<std::string> names;
    std::vector<double> values;
    values_.resolve(scene, names, values);
    StabilityOptions options = toStabilityOptions({variables_, {}, names, values, skip_low_high_, ""}, scene);

    control.report({"stability"});
    const auto prepared = [&](const SolvedScene& any) -> const MeasureEvaluator& {
      return design.evaluator(any);
    };
    const StabilityAnalysis analysis =
        analyseDesign(design.design(), {}, design.equilibrium(), design.solver(), prepared, options);
    requireConverged(analysis.nominal);
    control.throwIfCancelled();

    std::optional<Simulation> simulation;
    if (wants("simulation")) simulation = simulate(design, names, values, control);
    const EnvelopeTask envelope_task = envelopeTask(design, names, values);
    std::optional<EnvelopeCalculation> envelope;
    if (wants("envelope")) envelope = calculateEnvelope(envelope_task, design.snapshot(), false, control);

    control.report({"report"});
    const cable_variation::Harness harness = harnessAt(scene, options.values, options.moved);
    const cable_variation::ComponentPoses poses = componentPosesAt(scene, options.values, options.moved);
    const SolvedScene solved{harness, analysis.nominal, poses};
    Review review = startReview("Review", design.origin(), scene, options.values, solved);
    review.measures = analysis.measures;
    review.measured = analysis.values;
    review.variables = analysis.variables;
    review.stability = &analysis;
    if (simulation) {
      review.simulation = &*simulation;
      review.warnings.insert(review.warnings.end(), simulation->warnings.begin(), simulation->warnings.end());
    }
    if (envelope) {
      const cable_variation::OuterSurface& surface = envelope->surfaces.whole;
      review.envelope.emplace(cable_variation::EnvelopeFindings{envelope_task.options, envelope->envelope,
                                                                envelope->clearances, surface.mesh,
                                                                surface.excess, envelope->volume});
      review.warnings.insert(review.warnings.end(), envelope->warnings.begin(), envelope->warnings.end());
    }
    return answer(review, control);
  }

 private:
  void checkChapters() const {
    const std::vector<std::string>& known = chapterNames();
    for (const std::string& each : chapters_) {
      if (std::find(known.begin(), known.end(), each) != known.end()) continue;
      throw UsageError("--chapters: unknown chapter '" + each + "'" +
                       cable_variation::didYouMean(each, known));
    }
  }

  bool wants(const std::string& chapter) const {
    for (const std::string& each : chapters_) {
      if (each == chapter) return true;
    }
    return chapters_.empty();
  }

  Simulation simulate(LoadedDesign& design, const std::vector<std::string>& names,
                      const std::vector<double>& values, cable_variation::RunControl& control) {
    SimulationRequest request = simulation_;
    request.variables = variables_.empty() ? std::vector<std::string>{"*"} : variables_;
    request.nominal_variables = names;
    request.nominal_values = values;
    request.seed = seed_;
    const cable_variation::SimulationTask task =
        toSimulationTask(request, design.design(), {}, limits_.threads, limits_.memory_limit);
    const cable_variation::DesignSnapshot snapshot = design.snapshot();
    const SolvedScene any = design.solved();
    const MeasureEvaluator evaluator = design.evaluator(any).with(design.scene(), any);
    Simulation simulation =
        simulateVariation(design.scene(), evaluator, task.options,
                          solverAt(snapshot, task.options, task.other_design), {}, control.observer());
    if (simulation.ended_early) throw cable_variation::Cancelled();
    return simulation;
  }

  EnvelopeTask envelopeTask(const LoadedDesign& design, const std::vector<std::string>& names,
                            const std::vector<double>& values) {
    EnvelopeRequest request = envelope_;
    request.variables = variables_.empty() ? std::vector<std::string>{"*"} : variables_;
    request.nominal_variables = names;
    request.nominal_values = values;
    request.seed = seed_;
    return toEnvelopeTask(request, design.design(), {}, limits_.threads, limits_.memory_limit);
  }

  Answer answer(const Review& review, cable_variation::RunControl& control) const {
    Answer answer;
    const std::vector<MeasureVerdict> verdicts = verdictsOf(review.scene, evidenceOf(review));
    const cable_variation::OverallVerdict overall = overallVerdict(
        review.scene, verdicts,
        review.envelope ? review.envelope->clearances : std::vector<cable_variation::EnvelopeClearance>());
    answer.text = tableText(verdictTable(review.scene, verdicts)) + "\n" + toString(overall.verdict) +
                  (overall.text.empty() ? "" : ": " + overall.text) + "\n";
    if (review.envelope && !review.envelope->clearances.empty())
      answer.text += "\n" + tableText(clearanceTable(review.scene, *review.envelope));
    answer.warnings = review.warnings;
    const std::string page = reviewPage(review);
    control.complete();
    const std::string file = writeBeside(files_.output(), report_, ".html", page, answer.status.message);
    if (file.empty()) answer.status.code = cable_variation::StatusCode::io_error;
    if (!file.empty()) answer.text += file + "\n";
    answer.json.set("verdict", toString(overall.verdict)).set("text", overall.text);
    answer.json.set("measures", verdictsJson(review.scene, verdicts)).set("warnings", review.warnings);
    answer.json.set("report_file", file);
    return answer;
  }

  SceneOption scene_;
  ValueOptions values_;
  FileOptions files_;
  LimitOptions limits_;
  std::string report_ = "report";
  std::vector<std::string> chapters_, variables_;
  SimulationRequest simulation_;
  EnvelopeRequest envelope_;
  std::uint64_t seed_ = 0;
  bool skip_low_high_ = false;
};

}  // namespace

std::unique_ptr<Verb> makeReport() { return std::make_unique<ReportVerb>(); }

}  // namespace cable_variation_command
