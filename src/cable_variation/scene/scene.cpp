#include <cable_variation/scene/scene.h>

#include <algorithm>
#include <stdexcept>

#include <cable_variation/scene/cable_property.h>
#include <cable_variation/scene/deviations.h>
#include <cable_variation/scene/scene_contact.h>
#include <cable_variation/util/quantity.h>

namespace cable_variation {
namespace {

Pose designedPose(const Scene& scene, const std::string& name, const ComponentPoses& moved,
                  std::size_t depth) {
  const auto given = moved.find(name);
  if (name == "world") return {};
  if (given != moved.end()) return given->second;
  if (depth > scene.components.size())
    throw std::invalid_argument("component '" + name + "' rides on itself");
  const Component& component = scene.components[componentIndex(scene, name)];
  return designedPose(scene, component.parent, moved, depth + 1) * component.pose;
}

// Adds what the length left the arc length at to what the variable's value asks for.
void setArcLength(double length, double value, double nominal, const std::string& variable,
                  double& arc_length) {
  constexpr double kRounding = 1e-12;
  const double place = value + (arc_length - nominal);
  if (!(place >= 0.0 && place <= length * (1.0 + kRounding))) {
    throw std::invalid_argument("design variable '" + variable + "': arc length " + shortNumber(place) +
                                " m; expected " + Range{0.0, length, false}.text("m"));
  }
  arc_length = std::min(place, length);
}

void apply(const Scene& scene, const std::vector<std::pair<std::size_t, double>>& quantities,
           Harness& harness) {
  for (const auto& [index, value] : quantities) {
    const DesignVariable& variable = scene.design_variables[index];
    if (const auto* property = std::get_if<CableProperty>(&variable.target)) {
      try {
        setProperty(harness, *property, value, variable.nominal);
      } catch (const std::invalid_argument& error) {
        throw std::invalid_argument("design variable '" + variable.name + "': " + error.what());
      }
    }
  }
  // after the lengths, which move and bound them
  for (const auto& [index, value] : quantities) {
    const DesignVariable& variable = scene.design_variables[index];
    if (const auto* at = std::get_if<ClipArcLength>(&variable.target)) {
      Clip& clip = harness.clips[at->clip];
      setArcLength(harness.cables[clip.cable].length, value, scene.harness.clips[at->clip].arc_length,
                   variable.name, clip.arc_length);
    } else if (const auto* breakout = std::get_if<BreakoutArcLength>(&variable.target)) {
      Joint& joint = harness.joints[breakout->joint];
      setArcLength(harness.cables[joint.parent].length, value,
                   scene.harness.joints[breakout->joint].parent_arc_length, variable.name,
                   joint.parent_arc_length);
    }
  }
}

}  // namespace

Pose componentPose(const Scene& scene, const std::string& component, const ComponentPoses& moved) {
  return designedPose(scene, component, moved, 0);
}

ComponentPoses componentPosesAt(const Scene& scene, const DesignValues& values, const ComponentPoses& moved) {
  const auto frames = componentFrames(scene, deviationsOf(scene, values), moved);
  ComponentPoses poses;
  for (std::size_t i = 0; i < frames.size(); ++i) poses[scene.components[i].name] = frames[i].pose;
  return poses;
}

Harness harnessAt(const Scene& scene, const DesignValues& values, const ComponentPoses& moved) {
  const Deviations deviations = deviationsOf(scene, values);
  const auto frames = componentFrames(scene, deviations, moved);
  Harness harness = scene.harness;
  apply(scene, deviations.quantities, harness);
  for (std::size_t i = 0; i < harness.clips.size(); ++i) {
    const ClipMount& mount = scene.clip_mounts[i];
    const std::size_t component = componentIndex(scene, mount.component);
    const Pose carrier = component == ComponentFrame::kWorld ? Pose() : frames[component].pose;
    harness.clips[i].pose = carrier * mount.pose * deviations.clips[i].pose();
  }
  placeContacts(scene, frames, harness);
  if (!harness.cables.empty()) validate(harness);
  return harness;
}

}  // namespace cable_variation
