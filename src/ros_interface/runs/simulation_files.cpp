#include <ros_interface/runs/simulation_files.h>

#include <cable_variation/report/cable_variation_section.h>
#include <cable_variation/report/page.h>
#include <cable_variation/report/sample_csv.h>
#include <cable_variation/report/simulation_section.h>
#include <cable_variation/util/error.h>
#include <cable_variation/util/output_file.h>
#include <ros_interface/conversion/scene_loading.h>
#include <ros_interface/conversion/utc_time.h>

namespace cable_variation_ros {

using cable_variation::SampleCsv;
using cable_variation::SampleOutcome;
using cable_variation::SampleReceiver;
using cable_variation::Scene;
using cable_variation::Simulation;
using cable_variation::SimulationOptions;

namespace {

/// What was asked for, under the report's title.
std::vector<std::string> about(const Scene& scene, const SimulationOptions& options,
                               const Simulation& simulation) {
  std::vector<std::string> lines{scene.source, utcNow()};
  if (!options.motions.empty()) {
    std::string over = "Over the motion of ";
    for (const std::size_t index : options.motions) {
      over += (index == options.motions.front() ? "" : " and ") + scene.motions[index].name;
    }
    char times[96];
    if (options.to > options.from) {
      std::snprintf(times, sizeof times,
                    ", measures at their worst from %.3g s to %.3g s, solved at %zu times", options.from,
                    options.to, simulation.times.size());
    } else {
      std::snprintf(times, sizeof times, ", at %.3g s", options.from);
    }
    lines.push_back(over + times);
  }
  if (simulation.ended_early) lines.emplace_back("Ended early: these are the samples done by then");
  return lines;
}

}  // namespace

SimulationFiles::SimulationFiles(const OutputDirectory& output, const SimulationTask& task,
                                 const Scene& scene)
    : output_(output), task_(task), scene_(scene) {
  if (task.name.empty()) return;
  samples_path_ = output.fileFor(task.name, ".csv");
  samples_ = std::make_unique<SampleCsv>(samples_path_, scene, task.options.variables, task.options.measures,
                                         task.options.values);
}

SimulationFiles::~SimulationFiles() = default;

template <typename Write>
bool SimulationFiles::attempt(const Write& write) {
  try {
    write();
    return true;
  } catch (const cable_variation::FileError& problem) {
    if (!error_.empty()) error_ += "; ";
    error_ += problem.what();
    return false;
  }
}

SampleReceiver SimulationFiles::receiver() {
  if (!samples_) return {};
  return [this](std::uint64_t index, SampleOutcome outcome, const double* deviations, const double* values) {
    if (samples_broken_) return;
    samples_broken_ = !attempt([&] { samples_->add(index, outcome, deviations, values); });
  };
}

std::string SimulationFiles::written(const std::string& suffix, const std::string& contents) {
  const std::string path = output_.pathOf(task_.name, suffix);
  const bool done = attempt([&] { cable_variation::writeFile(path, contents); });
  return done ? path : "";
}

void SimulationFiles::finish(const Simulation& simulation,
                             cable_variation::SimulateVariationResponse& response) {
  if (!samples_) return;
  response.samples_file = samples_->partialPath();
  if (simulation.ended_early) {
    if (!samples_broken_) attempt([&] { samples_->stop(); });
  } else if (!samples_broken_ && attempt([&] { samples_->finish(); })) {
    response.samples_file = samples_path_;
  }
  samples_.reset();
  if (simulation.statistics.samples == 0) return;
  response.statistics_file = written("_statistics.csv", statisticsCsv(scene_, simulation.statistics));
  response.contributions_file = written("_contributions.csv", contributionCsv(scene_, simulation.statistics));
  std::vector<std::string> warnings = warningsOf(scene_);
  warnings.insert(warnings.end(), simulation.warnings.begin(), simulation.warnings.end());
  response.report_file =
      written(".html",
              cable_variation::reportPage(
                  "Variation simulation", about(scene_, task_.options, simulation), warnings,
                  {simulationSection(scene_, simulation.statistics, task_.options.values, &simulation.linear),
                   cableVariationSection(scene_, simulation)}));
}

}  // namespace cable_variation_ros
