#include <atomic>
#include <cmath>
#include <memory>
#include <utility>

#include <cable_variation/analysis/scene_loading.h>
#include <cable_variation/analysis/simulation_calculation.h>
#include <cable_variation/report/cable_variation_section.h>
#include <cable_variation/report/simulation_tables.h>
#include <cable_variation/util/count_text.h>
#include <cable_variation/util/number_text.h>
#include <command/loaded_design.h>
#include <command/scene_options.h>
#include <command/simulation_json.h>
#include <command/text_table.h>
#include <command/verb.h>

namespace cable_variation_command {

using cable_variation::numberText;
using cable_variation::SampleOutcome;
using cable_variation::Scene;
using cable_variation::Simulation;
using cable_variation::SimulationCalculation;
using cable_variation::SimulationStatistics;
using cable_variation::SimulationTask;

namespace {

std::string outcomesText(const SimulationStatistics& found) {
  std::string text = cable_variation::countText(found.samples, "sample") + ": ";
  if (found.count(SampleOutcome::solved) == found.samples) return text + "all solved\n";
  text += std::to_string(found.count(SampleOutcome::solved)) + " solved";
  const auto tell = [&](SampleOutcome outcome, const char* what) {
    if (found.count(outcome) > 0) text += ", " + std::to_string(found.count(outcome)) + " " + what;
  };
  tell(SampleOutcome::snapped, "snapped to another equilibrium, their values count");
  tell(SampleOutcome::not_converged, "without an equilibrium that was found");
  tell(SampleOutcome::impossible, "impossible to build");
  return text + "\n";
}

std::string textOf(const Scene& scene, const Simulation& simulation) {
  const SimulationStatistics& found = simulation.statistics;
  std::string text;
  if (found.samples > 1) {
    text += tableText(meanTable(scene, found)) + "\n" + tableText(capabilityTable(scene, found)) + "\n";
    if (found.contributions.first_order.size() > 0) {
      text += tableText(shareTable(scene, found, "Share of the variance, first-order Sobol' index",
                                   found.contributions.first_order)) +
              "\n";
    }
    text += tableText(largestVariationTable(scene, simulation)) + "\n";
  }
  text += outcomesText(found);
  text += std::string(toString(found.sampler)) + ", seed " + std::to_string(found.seed) + "; " +
          numberText(simulation.time, 3) + " s";
  if (simulation.time > 0.0)
    text += ", " + std::to_string(std::lround(static_cast<double>(found.samples) / simulation.time)) +
            " a second";
  return text + "\n";
}

class SimulateVerb : public Verb {
 public:
  void declare(Options& options) override {
    scene_.declare(options);
    options.count("samples", "COUNT", request_.samples,
                  "10,000; with --sigma_error no more than these, 1,000,000");
    options.number("sigma_error", "SHARE", "1", request_.sigma_error,
                   "stop when each sigma is known to this share, as 2%; default: after --samples");
    options.number("confidence", "SHARE", "1", request_.confidence, "of all intervals; default: 95%");
    options.count("seed", "NUMBER", request_.seed, "same seed, same figures; default: 1");
    options.text("sampler", "NAME", request_.sampler, "monte_carlo, latin_hypercube or sobol");
    options.texts("variables", "NAME", request_.variables, "that vary within their tolerances; default: all");
    options.texts("measures", "NAME", request_.measures, "default: all of the scene");
    values_.declare("nominal_variables", "nominal_values", options);
    options.texts("motions", "NAME", request_.motions, "played together; default: at rest");
    options.number("from_time", "TIME", "s", request_.from_time, "of the motions");
    options.number("to_time", "TIME", "s", request_.to_time,
                   "likewise, default: their end; negative: at --from_time alone");
    options.count("sections", "COUNT", request_.sections, "along each cable, for the variation along it; 33");
    options.text("name", "NAME", request_.name,
                 "write NAME.csv, NAME_statistics.csv, NAME_contributions.csv and NAME.html");
    files_.declare(options);
    limits_.declare(options);
  }

  bool keepsWhatWasDone() const override { return simulating_; }

  Answer run(cable_variation::RunControl& control) override {
    LoadedDesign design(scene_.load(control), files_.author);
    const Scene& loaded = design.scene();
    values_.resolve(loaded, request_.nominal_variables, request_.nominal_values);
    if (request_.variables.empty()) request_.variables = {"*"};
    const SimulationTask task =
        toSimulationTask(request_, design.design(), {}, limits_.threads, limits_.memory_limit);
    const cable_variation::OutputDirectory output = files_.output();
    if (!task.name.empty()) output.requireWritable();
    const cable_variation::DesignSnapshot snapshot = snapshotFor(task.options, design.snapshot());
    const Scene& scene = snapshot.design.scene;
    const cable_variation::SolvedScene any = design.solved();
    const cable_variation::MeasureEvaluator evaluator = design.evaluator(any).with(scene, any);
    control.throwIfCancelled();
    simulating_ = true;
    const SimulationCalculation found = calculateSimulation(task, snapshot, evaluator, output, control);

    Answer answer;
    answer.status = found.status;
    answer.json = simulationJson(scene, task.options.values, found.simulation);
    answer.json.set("samples_file", found.paths.samples).set("statistics_file", found.paths.statistics);
    answer.json.set("contributions_file", found.paths.contributions).set("report_file", found.paths.report);
    answer.json.set("report_time", found.report_time);
    if (found.simulation.statistics.samples > 0) answer.text = textOf(scene, found.simulation);
    for (const std::string& file :
         {found.paths.samples, found.paths.statistics, found.paths.contributions, found.paths.report})
      answer.text += file.empty() ? "" : file + "\n";
    answer.warnings = warningsOf(scene);
    const std::vector<std::string>& more = found.simulation.warnings;
    answer.warnings.insert(answer.warnings.end(), more.begin(), more.end());
    return answer;
  }

 private:
  SceneOption scene_;
  ValueOptions values_;
  FileOptions files_;
  LimitOptions limits_;
  cable_variation::SimulationRequest request_;
  std::atomic<bool> simulating_{false};
};

}  // namespace

std::unique_ptr<Verb> makeSimulate() { return std::make_unique<SimulateVerb>(); }

}  // namespace cable_variation_command
