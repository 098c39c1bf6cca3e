#include <cable_variation/analysis/simulation_task.h>

#include <numeric>

#include <cable_variation/envelope/envelope_memory.h>

#include <cable_variation/analysis/output_directory.h>
#include <cable_variation/analysis/design_values.h>
#include <cable_variation/analysis/name_lookup.h>
#include <cable_variation/analysis/request_fields.h>

namespace cable_variation {

namespace {

constexpr std::uint64_t kMostUnlessGiven = 1000000;  // with sigma_error; some minutes
constexpr std::uint32_t kMostSections = 2000;
constexpr std::uint32_t kMostShapes = 500;  // what RViz draws without delay
// Bytes of a place on a cable: in a shape that is kept, its message and marker; in the figures of all blocks
// of samples under way.
constexpr double kKeptPlace = 100.0, kFigures = 4000.0;
constexpr double kAlongCables = 0.5;  // of the memory limit

/// A share strictly between 0 and 1, or `fallback` for 0.
double shareOr(double fallback, double value, const char* field) {
  if (!(value >= 0.0 && value < 1.0)) refuse(field, value, "above 0, below 1, or 0: its default");
  return value == 0.0 ? fallback : value;
}

void readCounts(const SimulationRequest& request, SimulationOptions& options) {
  if (request.samples > kMostSamples) {
    throw std::invalid_argument("samples: is " + std::to_string(request.samples) + ", expected at most " +
                                std::to_string(kMostSamples) + ": at 10,000 a second that is a day");
  }
  options.sigma_error = shareOr(0.0, request.sigma_error, "sigma_error");
  options.confidence = shareOr(options.confidence, request.confidence, "confidence");
  if (options.sigma_error > 0.0) options.samples = kMostUnlessGiven;
  if (request.samples != 0) options.samples = request.samples;
  options.first_sample = request.first_sample;
  if (request.seed != 0) options.seed = request.seed;
  if (!request.sampler.empty()) options.sampler = samplerTypeOf(request.sampler);
  if (options.sigma_error > 0.0 && options.sampler == SamplerType::latin_hypercube) {
    refuse("sigma_error", options.sigma_error,
           "0 with sampler latin_hypercube, whose samples are of a count; or sampler monte_carlo or sobol");
  }
}

std::vector<std::size_t> measuresOf(const std::vector<std::string>& names, const Scene& scene) {
  if (!names.empty()) return indicesOf(names, scene.measures, "measure");
  std::vector<std::size_t> all(scene.measures.size());
  std::iota(all.begin(), all.end(), std::size_t{0});
  return all;
}

// What the shapes along the cables take, of all times of a motion that are simulated.
void refuseMoreThanMemory(const SimulationOptions& options, const Scene& scene, double memory_limit) {
  const auto count = [](std::size_t number) { return static_cast<double>(number); };
  const double places = (options.motions.empty() ? 1.0 : count(options.most_times)) *
                        count(scene.harness.cables.size()) * count(options.sections);
  const double kept = kKeptPlace * places * count(options.kept_shapes), figures = kFigures * places;
  const double allowed = kAlongCables * memory_limit;
  if (kept + figures <= allowed) return;
  const bool sections = figures > allowed;
  refuse(sections ? "sections" : "sample_shapes", count(sections ? options.sections : options.kept_shapes),
         "fewer: with " + std::to_string(options.sections) + " sections and " +
             std::to_string(options.kept_shapes) + " shapes it would take " + memoryText(kept + figures) +
             ", allowed are " + memoryText(allowed) + " of ~memory_limit");
}

}  // namespace

SimulationTask toSimulationTask(const SimulationRequest& request, const Design& design,
                                const ComponentPoses& moved, std::size_t threads, double memory_limit) {
  const Scene& scene = design.scene;
  SimulationTask task;
  SimulationOptions& options = task.options;
  options.variables = variedVariables(request.variables, scene);
  options.measures = measuresOf(request.measures, scene);
  options.motions = playedMotions(request.motions, scene);
  const TimeSpan span = timesOf(options.motions, request.from_time, request.to_time, scene);
  options.from = span.from;
  options.to = span.to;
  options.values = toDesignValues(scene, request.nominal_variables, request.nominal_values);
  task.other_design = !options.values.empty();
  options.values.insert(design.shifted.begin(), design.shifted.end());
  if (options.motions.empty()) options.moved = moved;
  readCounts(request, options);
  if (request.sections != 0) {
    if (request.sections < 2 || request.sections > kMostSections) {
      refuse("sections", request.sections, "2 to " + std::to_string(kMostSections) + ", or 0: its default");
    }
    options.sections = request.sections;
  }
  if (request.sample_shapes > kMostShapes) {
    refuse("sample_shapes", request.sample_shapes, "at most " + std::to_string(kMostShapes));
  }
  options.kept_shapes = request.sample_shapes;
  options.threads = threads;
  refuseMoreThanMemory(options, scene, memory_limit);
  if (!request.name.empty()) OutputDirectory::checkName(request.name);
  task.name = request.name;
  return task;
}

}  // namespace cable_variation
