// Requests of the services, every field made of bytes: what they ask of a design is refused with a message,
// or is a task that keeps to its bounds. That an answer comes of it too, is what
// test/ros/hostile_requests_test.py asks.
#include <cmath>
#include <string>
#include <vector>

#include <cable_variation/AnalyzeStability.h>
#include <cable_variation/CheckPath.h>
#include <cable_variation/GenerateEnvelope.h>
#include <cable_variation/SetDesign.h>
#include <cable_variation/SimulateVariation.h>
#include <cable_variation/SolveEquilibrium.h>

#include <cable_variation/analysis/design_stability.h>
#include <cable_variation/analysis/design_trial.h>
#include <cable_variation/analysis/design_values.h>
#include <cable_variation/analysis/envelope_task.h>
#include <cable_variation/analysis/output_directory.h>
#include <cable_variation/analysis/simulation_task.h>
#include <cable_variation/scene_file/scene_reader.h>
#include <cable_variation/util/error.h>
#include <ros_interface/conversion/design_request.h>
#include <ros_interface/conversion/path_request.h>
#include <ros_interface/runs/requests.h>

#include "field_stream.h"
#include "fuzz_input.h"

namespace cable_variation {
namespace {

const char* const kScene = R"(
components:
  - {name: holder, pose: {position: [0.25, 0, 0]}}
  - {name: lever, parent: holder, pose: {position: [0, 0.1, 0]}}
materials:
  bundle: {young_modulus: 1.0e8, poisson_ratio: 0.25, density: 2000}
cables:
  - {name: strand, length: 312 mm, section: {type: solid, radius: 4 mm, material: bundle}}
clips:
  - {name: A, type: fixed, cable: strand, at: start, pose: {position: [0, 0, 0]}}
  - {name: B, type: fixed, cable: strand, at: end, component: holder, pose: {position: [0, 0, 0]}}
  - {name: C, type: sliding, cable: strand, at: 150 mm, pose: {position: [0.12, 0, -0.05]}}
design_variables:
  - {name: b_z, clip: B, translate: z, tolerance: 5 mm, distribution: {type: normal, sigma: 3}}
  - {name: a_ry, clip: A, rotate: y, tolerance: 5 deg, distribution: {type: normal, sigma: 3}}
  - {name: strand_length, cable: strand, property: length, tolerance: 3 mm, distribution: {type: uniform}}
  - {name: holder_x, component: holder, translate: x, tolerance: 1 mm}
measures:
  - {name: height, type: position, cable: strand, at: 100 mm, direction: [0, 0, 1]}
  - {name: change, type: similarity}
)";

const Design& design() {
  static const Design kDesign{
      readSceneText(kScene, "fuzz.yaml", [](const std::string&) { return std::string(); }), {}, {}};
  return kDesign;
}

const std::vector<std::string>& words() {
  static const std::vector<std::string> kWords{
      "*",      "strand",        "A",        "B",      "C",      "holder", "lever",  "world", "b_z",
      "a_ry",   "strand_length", "holder_x", "height", "change", "fixed",  "eyelet", "sobol", "random",
      "linear", "run",           "../run",   "a/b",    "%s"};
  return kWords;
}

template <typename Request>
Request requestOf(FuzzBytes& bytes) {
  Request request;
  FieldStream stream(bytes, words());
  ros::serialization::Serializer<Request>::allInOne(stream, request);
  return request;
}

void require(bool sound, const char* what) {
  if (!sound) throw std::logic_error(what);
}

void requireFinite(const DesignValues& values) {
  for (const auto& [name, value] : values)
    require(std::isfinite(value), "a value that is no number is taken");
}

void checkName(const std::string& name) {
  if (!name.empty()) OutputDirectory::checkName(name);
}

void ask(FuzzBytes& bytes) {
  using namespace cable_variation_ros;
  constexpr double kMemory = 1e9;
  const Scene& scene = design().scene;
  switch (bytes.below(6)) {
    case 0: {
      const auto request = requestOf<SolveEquilibriumRequest>(bytes);
      checkName(fromMessage(request).report);
      requireFinite(toDesignValues(scene, request.variables, request.values));
      if (!request.motion.empty()) placesDuring(design(), request.motion, request.time);
      return;
    }
    case 1: {
      const StabilityOptions options =
          toStabilityOptions(fromMessage(requestOf<AnalyzeStabilityRequest>(bytes)), scene);
      requireFinite(options.values);
      for (const std::size_t each : options.variables)
        require(each < scene.design_variables.size(), "a variable that is none");
      for (const std::size_t each : options.measures)
        require(each < scene.measures.size(), "a measure that is none");
      return;
    }
    case 2: {
      const EnvelopeTask task =
          toEnvelopeTask(fromMessage(requestOf<GenerateEnvelopeRequest>(bytes)), design(), {}, 1, kMemory);
      requireFinite(task.options.values);
      require(task.mesh_excess >= 0.0 && std::isfinite(task.mesh_excess), "a mesh that cannot be");
      checkName(task.name);
      return;
    }
    case 3: {
      const auto request = requestOf<SimulateVariationRequest>(bytes);
      figureOf(request.show);
      const SimulationTask task = toSimulationTask(fromMessage(request), design(), {}, 1, kMemory);
      requireFinite(task.options.values);
      require(task.options.samples > 0, "no samples");
      checkName(task.name);
      return;
    }
    case 4: {
      const PathRequest path = toPath(requestOf<CheckPathRequest>(bytes), design(), scene.harness, {}, {});
      require(path.step > 0.0 && std::isfinite(path.step), "a step that cannot be");
      return;
    }
    default: {
      const Design changed = edited(design(), requestOf<SetDesignRequest>(bytes));
      require(faultsOf(sceneOf(changed).harness).empty(), "a design that is none");
    }
  }
}

}  // namespace
}  // namespace cable_variation

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace cable_variation;
  FuzzBytes bytes(data, size);
  return acceptsOrRefuses([&] {
    try {
      ask(bytes);
    } catch (const NotFound& error) {
      if (*error.what() == '\0') throw std::logic_error("a refusal without a message");
    }
  });
}
