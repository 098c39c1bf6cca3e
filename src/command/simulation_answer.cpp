#include <command/simulation_answer.h>

#include <cmath>

#include <cable_variation/analysis/scene_loading.h>
#include <cable_variation/report/cable_variation_section.h>
#include <cable_variation/report/simulation_tables.h>
#include <cable_variation/util/count_text.h>
#include <cable_variation/util/number_text.h>
#include <command/simulation_json.h>
#include <command/text_table.h>

namespace cable_variation_command {

using cable_variation::numberText;
using cable_variation::SampleOutcome;
using cable_variation::Scene;
using cable_variation::Simulation;
using cable_variation::SimulationCalculation;
using cable_variation::SimulationStatistics;

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
  if (simulation.time > 0.0) {
    const double rate = static_cast<double>(found.samples) / simulation.time;
    text += ", " + (rate < 10.0 ? numberText(rate, 2) : std::to_string(std::lround(rate))) + " a second";
  }
  return text + "\n";
}

}  // namespace

Answer simulationAnswer(const Scene& scene, const cable_variation::DesignValues& values,
                        const SimulationCalculation& found) {
  Answer answer;
  answer.status = found.status;
  answer.json = simulationJson(scene, values, found.simulation);
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

}  // namespace cable_variation_command
