#include <cable_variation/scene/scene.h>

#include <cmath>
#include <stdexcept>

#include <cable_variation/scene/cable_property.h>
#include <cable_variation/scene/locating_scheme.h>
#include <cable_variation/scene/quantity.h>

namespace cable_variation {
namespace {

using Eigen::Vector3d;

// A small rigid motion in a frame's own axes: shift t [m] and rotation vector θ [rad].
struct Deviation {
  Vector3d translation = Vector3d::Zero();
  Vector3d rotation = Vector3d::Zero();

  Pose pose() const {
    const double angle = rotation.norm();
    const Vector3d axis = angle > 0.0 ? Vector3d(rotation / angle) : Vector3d(Vector3d::UnitX());
    return {translation, Eigen::Quaterniond(Eigen::AngleAxisd(angle, axis))};
  }
};

// What the values of the design variables ask for.
struct Deviations {
  std::map<std::size_t, Deviation> clips;
  std::map<std::size_t, Deviation> components;
  std::map<std::size_t, std::array<double, 6>> locators;
  std::vector<std::pair<const DesignVariable*, double>> quantities;  ///< of cables, and arc lengths
};

const DesignVariable& variableOf(const Scene& scene, const std::string& name) {
  for (const DesignVariable& variable : scene.design_variables) {
    if (variable.name == name) return variable;
  }
  throw std::invalid_argument("there is no design variable '" + name + "'");
}

Deviations collect(const Scene& scene, const DesignValues& values) {
  Deviations all;
  for (const auto& [name, value] : values) {
    const DesignVariable& variable = variableOf(scene, name);
    if (!std::isfinite(value)) {
      throw std::invalid_argument("design variable '" + name + "': value " + shortNumber(value) +
                                  "; expected a finite number");
    }
    if (const auto* t = std::get_if<ClipTranslation>(&variable.target)) {
      all.clips[t->clip].translation[static_cast<int>(t->axis)] += value;
    } else if (const auto* r = std::get_if<ClipRotation>(&variable.target)) {
      all.clips[r->clip].rotation[static_cast<int>(r->axis)] += value;
    } else if (const auto* ct = std::get_if<ComponentTranslation>(&variable.target)) {
      all.components[ct->component].translation[static_cast<int>(ct->axis)] += value;
    } else if (const auto* cr = std::get_if<ComponentRotation>(&variable.target)) {
      all.components[cr->component].rotation[static_cast<int>(cr->axis)] += value;
    } else if (const auto* l = std::get_if<LocatorDeviation>(&variable.target)) {
      all.locators.try_emplace(l->component).first->second[l->locator] += value;
    } else {
      all.quantities.emplace_back(&variable, value);
    }
  }
  return all;
}

std::size_t componentIndex(const Scene& scene, const std::string& name) {
  for (std::size_t i = 0; i < scene.components.size(); ++i) {
    if (scene.components[i].name == name) return i;
  }
  throw std::invalid_argument("there is no component '" + name + "'");
}

// The component's own deviation, in its frame.
Pose deviationOf(const Scene& scene, std::size_t component, const Deviations& deviations) {
  Pose pose;
  const auto locators = deviations.locators.find(component);
  if (locators != deviations.locators.end()) {
    const Component& part = scene.components[component];
    try {
      pose = locatedPose(part.locators, locators->second);
    } catch (const std::invalid_argument& error) {
      throw std::invalid_argument("component '" + part.name + "': " + error.what());
    }
  }
  const auto motion = deviations.components.find(component);
  return motion == deviations.components.end() ? pose : pose * motion->second.pose();
}

Pose designedPose(const Scene& scene, const std::string& name, const ComponentPoses& moved,
                  std::size_t depth);

// The motion, in the world, that the deviations of a component and of those it
// rides on give it.
Pose worldDeviation(const Scene& scene, const std::string& name, const Deviations& deviations,
                    const ComponentPoses& moved, std::size_t depth) {
  if (name == "world" || (deviations.components.empty() && deviations.locators.empty())) return {};
  if (depth > scene.components.size())
    throw std::invalid_argument("component '" + name + "' rides on itself");
  const std::size_t index = componentIndex(scene, name);
  const Pose designed = designedPose(scene, name, moved, 0);
  const Pose own = designed * deviationOf(scene, index, deviations) * designed.inverse();
  return worldDeviation(scene, scene.components[index].parent, deviations, moved, depth + 1) * own;
}

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

Pose poseWith(const Scene& scene, const std::string& name, const Deviations& deviations,
              const ComponentPoses& moved) {
  return worldDeviation(scene, name, deviations, moved, 0) * designedPose(scene, name, moved, 0);
}

void setArcLength(const Harness& harness, std::size_t cable, double value, const std::string& variable,
                  double& arc_length) {
  const Range range{0.0, harness.cables[cable].length, false};
  if (!range.holds(value)) {
    throw std::invalid_argument("design variable '" + variable + "': arc length " + shortNumber(value) +
                                " m; expected " + range.text("m"));
  }
  arc_length = value;
}

void apply(const std::vector<std::pair<const DesignVariable*, double>>& quantities, Harness& harness) {
  for (const auto& [variable, value] : quantities) {
    if (const auto* property = std::get_if<CableProperty>(&variable->target)) {
      try {
        setProperty(harness, *property, value);
      } catch (const std::invalid_argument& error) {
        throw std::invalid_argument("design variable '" + variable->name + "': " + error.what());
      }
    }
  }
  // after the lengths, which bound them
  for (const auto& [variable, value] : quantities) {
    if (const auto* at = std::get_if<ClipArcLength>(&variable->target)) {
      Clip& clip = harness.clips[at->clip];
      setArcLength(harness, clip.cable, value, variable->name, clip.arc_length);
    } else if (const auto* breakout = std::get_if<BreakoutArcLength>(&variable->target)) {
      Joint& joint = harness.joints[breakout->joint];
      setArcLength(harness, joint.parent, value, variable->name, joint.parent_arc_length);
    }
  }
}

}  // namespace

Pose componentPose(const Scene& scene, const std::string& component, const ComponentPoses& moved) {
  return designedPose(scene, component, moved, 0);
}

ComponentPoses componentPosesAt(const Scene& scene, const DesignValues& values, const ComponentPoses& moved) {
  const Deviations deviations = collect(scene, values);
  ComponentPoses poses;
  for (const Component& component : scene.components) {
    poses[component.name] = poseWith(scene, component.name, deviations, moved);
  }
  return poses;
}

Harness harnessAt(const Scene& scene, const DesignValues& values, const ComponentPoses& moved) {
  const Deviations deviations = collect(scene, values);
  Harness harness = scene.harness;
  apply(deviations.quantities, harness);
  for (std::size_t i = 0; i < harness.clips.size(); ++i) {
    const ClipMount& mount = scene.clip_mounts[i];
    Pose& pose = harness.clips[i].pose;
    pose = poseWith(scene, mount.component, deviations, moved) * mount.pose;
    const auto own = deviations.clips.find(i);
    if (own != deviations.clips.end()) pose = pose * own->second.pose();
  }
  if (!harness.cables.empty()) validate(harness);
  return harness;
}

}  // namespace cable_variation
