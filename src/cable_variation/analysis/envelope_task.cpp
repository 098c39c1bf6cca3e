#include <cable_variation/analysis/envelope_task.h>

#include <algorithm>
#include <cmath>

#include <cable_variation/envelope/clearance/envelope_clearance.h>
#include <cable_variation/analysis/output_directory.h>
#include <cable_variation/analysis/design_values.h>
#include <cable_variation/analysis/name_lookup.h>
#include <cable_variation/analysis/request_fields.h>

namespace cable_variation {

namespace {

constexpr std::uint32_t kMostShapes = 10000000;  // some hours
// Shares of the memory limit for the envelope itself, and for its mesh while all else is kept; the rest is
// for what becomes of it: messages, markers, files.
constexpr double kEnvelopeMemory = 0.5, kMeshMemory = 0.2;
constexpr double kLargestLength = 1.0;  // [m]; of what is meant to be small

double lengthOr(double fallback, double value, const char* field) {
  if (!(value >= 0.0 && value <= kLargestLength))
    refuse(field, value, "above 0, at most 1 m, or 0: its default");
  return value == 0.0 ? fallback : value;
}

std::size_t shapesOr(std::size_t fallback, std::uint32_t value, const char* field) {
  if (value > kMostShapes) refuse(field, value, "at most 10 million shapes");
  return value == 0 ? fallback : value;
}

std::vector<std::size_t> variablesOf(const EnvelopeRequest& request, const Scene& scene) {
  if (!request.motion_only) {
    return variedVariables(request.variables, scene, " (or motion_only with a motion)");
  }
  if (!request.variables.empty()) {
    throw std::invalid_argument("variables: some are given, expected none with motion_only");
  }
  if (request.motions.empty())
    throw std::invalid_argument("motions: is empty, expected one with motion_only");
  return {};
}

double probabilityOf(const EnvelopeRequest& request) {
  const double probability = request.probability;
  if (probability == 0.0) return 0.0;
  if (!(probability > 0.0 && probability < 1.0))
    refuse("probability", probability, "above 0 and below 1, as 0.9973, or 0: all that the tolerances allow");
  if (!request.motions.empty()) refuse("probability", probability, "0 over motions");
  if (request.non_conservative) refuse("probability", probability, "0 with non_conservative");
  return probability;
}

}  // namespace

EnvelopeTask toEnvelopeTask(const EnvelopeRequest& request, const Design& design, const ComponentPoses& moved,
                            std::size_t threads, double memory_limit) {
  const Scene& scene = design.scene;
  const EnvelopeOptions defaults;
  EnvelopeTask task;
  EnvelopeOptions& options = task.options;
  options.cables = indicesOf(request.cables, scene.harness.cables, "cable");
  options.motions = playedMotions(request.motions, scene);
  options.variables = variablesOf(request, scene);
  if (request.to_time < 0.0) refuse("to_time", request.to_time, "0 or more");
  const TimeSpan span = timesOf(options.motions, request.from_time, request.to_time, scene);
  if (!options.motions.empty()) {
    options.from = span.from;
    options.to = span.to;
  }
  options.values = toDesignValues(scene, request.nominal_variables, request.nominal_values);
  task.other_design = !options.values.empty();
  options.values.insert(design.shifted.begin(), design.shifted.end());
  if (options.motions.empty()) options.moved = moved;
  options.frames = clearanceFrames(scene, options);
  options.probability = probabilityOf(request);
  options.margin = lengthOr(defaults.margin, request.margin, "margin");
  options.conservative = !request.non_conservative;
  options.verification = shapesOr(options.probability > 0.0 ? 0 : defaults.verification,
                                  request.verification_shapes, "verification_shapes");
  options.tightness = shapesOr(0, request.tightness_shapes, "tightness_shapes");
  options.voxel = lengthOr(0.0, request.tightness_voxel, "tightness_voxel");
  options.seed = request.seed == 0 ? defaults.seed : request.seed;
  options.threads = threads;
  options.memory_limit = kEnvelopeMemory * memory_limit;
  task.mesh_memory = kMeshMemory * memory_limit;
  task.mesh_excess = lengthOr(0.0, request.mesh_excess, "mesh_excess");
  if (!(std::abs(request.skip_near_clips) <= kLargestLength)) {
    refuse("skip_near_clips", request.skip_near_clips, "at most 1 m");
  }
  if (request.skip_near_clips != 0.0) task.skip_near_clips = std::max(request.skip_near_clips, 0.0);
  if (!request.name.empty()) OutputDirectory::checkName(request.name);
  task.name = request.name;
  return task;
}

}  // namespace cable_variation
