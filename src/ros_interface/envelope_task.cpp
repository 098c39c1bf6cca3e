#include <ros_interface/envelope_task.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>
#include <sstream>
#include <variant>

#include <cable_variation/scene/moving_components.h>
#include <ros_interface/design_values.h>
#include <ros_interface/name_lookup.h>
#include <ros_interface/output_directory.h>

namespace cable_variation_ros {

using cable_variation::Component;
using cable_variation::DesignVariable;
using cable_variation::EnvelopeOptions;
using cable_variation::GenerateEnvelopeRequest;
using cable_variation::Motion;
using cable_variation::Scene;

namespace {

constexpr std::uint32_t kMostShapes = 10000000;  // some hours
constexpr double kLargestLength = 1.0;           // [m]; of what is meant to be small

[[noreturn]] void refuse(const char* field, double value, const std::string& expected) {
  std::ostringstream text;
  text << field << ": is " << value << ", expected " << expected;
  throw std::invalid_argument(text.str());
}

double lengthOr(double fallback, double value, const char* field) {
  if (!(value >= 0.0 && value <= kLargestLength))
    refuse(field, value, "above 0, at most 1 m, or 0: its default");
  return value == 0.0 ? fallback : value;
}

std::size_t shapesOr(std::size_t fallback, std::uint32_t value, const char* field) {
  if (value > kMostShapes) refuse(field, value, "at most 10 million shapes");
  return value == 0 ? fallback : value;
}

std::vector<std::size_t> variablesOf(const GenerateEnvelopeRequest& request, const Scene& scene) {
  if (request.motion_only) {
    if (!request.variables.empty()) {
      throw std::invalid_argument("variables: some are given, expected none with motion_only");
    }
    if (request.motions.empty())
      throw std::invalid_argument("motions: is empty, expected one with motion_only");
    return {};
  }
  if (request.variables.empty()) {
    throw std::invalid_argument(
        "variables: is empty, expected names of design variables, or ['*'] for all of the scene (or "
        "motion_only "
        "with a motion)");
  }
  if (request.variables != std::vector<std::string>{"*"}) {
    return indicesOf(request.variables, scene.design_variables, "design variable");
  }
  if (scene.design_variables.empty()) {
    throw std::invalid_argument("variables: ['*'], but the scene has no design variables");
  }
  std::vector<std::size_t> all(scene.design_variables.size());
  std::iota(all.begin(), all.end(), std::size_t{0});
  return all;
}

std::vector<std::size_t> motionsOf(const GenerateEnvelopeRequest& request, const Scene& scene) {
  std::vector<std::size_t> motions = indicesOf(request.motions, scene.motions, "motion");
  std::set<std::string> moved;
  for (const std::size_t index : motions) {
    const Motion& motion = scene.motions[index];
    if (motion.samples.empty()) throw std::invalid_argument("motion '" + motion.name + "': has no poses");
    if (!moved.insert(motion.component).second) {
      throw std::invalid_argument("motions: two of them move component '" + motion.component +
                                  "', expected one");
    }
  }
  return motions;
}

void readTimes(const GenerateEnvelopeRequest& request, const Scene& scene, EnvelopeOptions& options) {
  if (options.motions.empty()) {
    if (request.from_time != 0.0) refuse("from_time", request.from_time, "0 without motions");
    if (request.to_time != 0.0) refuse("to_time", request.to_time, "0 without motions");
    return;
  }
  double end = 0.0;
  for (const std::size_t index : options.motions) end = std::max(end, scene.motions[index].duration());
  std::ostringstream bounds;
  bounds << " to " << end << " s, the end of the motions";
  if (!(request.from_time >= 0.0 && request.from_time <= end)) {
    refuse("from_time", request.from_time, "0" + bounds.str());
  }
  options.from = request.from_time;
  options.to = request.to_time == 0.0 ? end : request.to_time;
  if (!(options.to >= options.from && options.to <= end)) {
    refuse("to_time", request.to_time, "from_time" + bounds.str());
  }
}

std::optional<std::size_t> componentOf(const DesignVariable& variable) {
  using namespace cable_variation;
  if (const auto* translation = std::get_if<ComponentTranslation>(&variable.target))
    return translation->component;
  if (const auto* rotation = std::get_if<ComponentRotation>(&variable.target)) return rotation->component;
  if (const auto* locator = std::get_if<LocatorDeviation>(&variable.target)) return locator->component;
  return std::nullopt;
}

/// Components with a shape that move or vary, or ride on what does.
std::vector<std::string> framesOf(const Scene& scene, const EnvelopeOptions& options) {
  std::set<std::string> movers;
  for (const std::size_t index : options.motions) movers.insert(scene.motions[index].component);
  for (const std::size_t index : options.variables) {
    const auto component = componentOf(scene.design_variables[index]);
    if (component) movers.insert(scene.components[*component].name);
  }
  const auto rides = [&](const Component& component) {
    const Component* at = &component;
    for (std::size_t steps = 0; steps <= scene.components.size(); ++steps) {
      if (movers.count(at->name) != 0) return true;
      const auto parent = std::find_if(scene.components.begin(), scene.components.end(),
                                       [&](const Component& each) { return each.name == at->parent; });
      if (parent == scene.components.end()) return false;
      at = &*parent;
    }
    return false;
  };
  std::vector<std::string> frames;
  for (const Component& component : scene.components) {
    if (!component.visuals.empty() && rides(component)) frames.push_back(component.name);
  }
  return frames;
}

}  // namespace

EnvelopeTask toEnvelopeTask(const GenerateEnvelopeRequest& request, const cable_variation::Design& design,
                            const cable_variation::ComponentPoses& moved, std::size_t threads) {
  const Scene& scene = design.scene;
  const EnvelopeOptions defaults;
  EnvelopeTask task;
  EnvelopeOptions& options = task.options;
  options.cables = indicesOf(request.cables, scene.harness.cables, "cable");
  options.motions = motionsOf(request, scene);
  options.variables = variablesOf(request, scene);
  readTimes(request, scene, options);
  options.values = toDesignValues(scene, request.nominal_variables, request.nominal_values);
  task.other_design = !options.values.empty();
  options.values.insert(design.shifted.begin(), design.shifted.end());
  if (options.motions.empty()) options.moved = moved;
  options.frames = framesOf(scene, options);
  options.margin = lengthOr(defaults.margin, request.margin, "margin");
  options.conservative = !request.non_conservative;
  options.verification = shapesOr(defaults.verification, request.verification_shapes, "verification_shapes");
  options.tightness = shapesOr(0, request.tightness_shapes, "tightness_shapes");
  options.voxel = lengthOr(0.0, request.tightness_voxel, "tightness_voxel");
  options.seed = request.seed == 0 ? defaults.seed : request.seed;
  options.threads = threads;
  task.mesh_excess = lengthOr(0.0, request.mesh_excess, "mesh_excess");
  if (!(std::abs(request.skip_near_clips) <= kLargestLength)) {
    refuse("skip_near_clips", request.skip_near_clips, "at most 1 m");
  }
  if (request.skip_near_clips != 0.0) task.skip_near_clips = std::max(request.skip_near_clips, 0.0);
  if (!request.name.empty()) OutputDirectory::checkName(request.name);
  task.name = request.name;
  task.show_pieces = request.show_pieces;
  return task;
}

}  // namespace cable_variation_ros
