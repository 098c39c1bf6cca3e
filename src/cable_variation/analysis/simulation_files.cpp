#include <cable_variation/analysis/simulation_files.h>

#include <cable_variation/report/review.h>
#include <cable_variation/report/sample_csv.h>
#include <cable_variation/report/simulation_section.h>
#include <cable_variation/scene/moving_components.h>
#include <cable_variation/util/error.h>
#include <cable_variation/util/output_file.h>
#include <cable_variation/analysis/other_reports.h>
#include <cable_variation/analysis/review_start.h>

namespace cable_variation {

namespace {

// Bytes of a sample: its number and outcome, a number in NAME.csv and in a block; of a place on a cable.
constexpr double kCsvSample = 16.0, kCsvNumber = 20.0, kBlockNumber = 8.0, kBlockPlace = 1.0;
constexpr const char* kTitle = "Variation simulation";

/// What was asked for, at the head of the report.
std::vector<ReportFact> about(const Scene& scene, const SimulationOptions& options,
                              const Simulation& simulation) {
  std::vector<ReportFact> facts{{"Samples", std::to_string(simulation.statistics.samples)}};
  if (simulation.ended_early) facts.front().text += ". Ended early: these are the samples done by then";
  if (options.motions.empty()) return facts;
  char times[96];
  if (options.to > options.from) {
    std::snprintf(times, sizeof times, ", measures at their worst from %.3g s to %.3g s, solved at %zu times",
                  options.from, options.to, simulation.times.size());
  } else {
    std::snprintf(times, sizeof times, ", at %.3g s", options.from);
  }
  facts.push_back({"Motion", motionText(scene, options.motions) + times});
  return facts;
}

/// At the time that the simulation shows the cables at.
ComponentPoses posesShown(const Scene& scene, const SimulationOptions& options,
                          const Simulation& simulation) {
  if (options.motions.empty()) return componentPosesAt(scene, options.values, options.moved);
  std::vector<const Motion*> motions;
  for (const std::size_t index : options.motions) motions.push_back(&scene.motions[index]);
  return componentPosesAt(scene, options.values, posesDuring(scene, motions, simulation.shown_time));
}

}  // namespace

void requireSpace(const OutputDirectory& output, const SimulationTask& task, const Scene& scene) {
  const SimulationOptions& options = task.options;
  if (options.sigma_error > 0.0) return;
  const auto count = [](std::uint64_t number) { return static_cast<double>(number); };
  const double columns = count(options.variables.size() + options.measures.size());
  const double places = count(scene.harness.cables.size() * options.sections);
  const double sample = kCsvSample + (kCsvNumber + kBlockNumber) * columns + kBlockPlace * places;
  output.requireSpace(count(options.samples) * sample);
}

SimulationFiles::SimulationFiles(const OutputDirectory& output, const SimulationTask& task,
                                 const Scene& scene, const DesignOrigin& origin)
    : output_(output), task_(task), scene_(scene), origin_(origin) {
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
  } catch (const FileError& problem) {
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
  const bool done = attempt([&] { writeFile(path, contents); });
  return done ? path : "";
}

SimulationPaths SimulationFiles::finish(const Simulation& simulation) {
  SimulationPaths paths;
  if (!samples_) return paths;
  const bool kept = attempt([&] { keepOtherReport(output_, task_.name, kTitle); });
  paths.samples = samples_->partialPath();
  if (simulation.ended_early) {
    if (!samples_broken_) attempt([&] { samples_->stop(); });
  } else if (kept && !samples_broken_ && attempt([&] { samples_->finish(); })) {
    paths.samples = samples_path_;
  }
  samples_.reset();
  if (simulation.statistics.samples == 0) return paths;
  paths.statistics = written("_statistics.csv", statisticsCsv(scene_, simulation.statistics));
  paths.contributions = written("_contributions.csv", contributionCsv(scene_, simulation.statistics));
  const SimulationOptions& options = task_.options;
  const ComponentPoses poses = posesShown(scene_, options, simulation);
  const SolvedScene solved{simulation.harness, simulation.linear.nominal, poses};
  Review review = startReview(kTitle, origin_, scene_, options.values, solved);
  review.about = about(scene_, options, simulation);
  review.warnings.insert(review.warnings.end(), simulation.warnings.begin(), simulation.warnings.end());
  review.measures = simulation.linear.measures;
  review.measured = simulation.linear.values;
  review.variables = simulation.statistics.variables;
  review.simulation = &simulation;
  if (kept) paths.report = written(".html", reviewPage(review));
  return paths;
}

}  // namespace cable_variation
