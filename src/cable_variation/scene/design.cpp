#include <cable_variation/scene/design.h>

#include <cmath>
#include <optional>
#include <stdexcept>
#include <utility>
#include <variant>
#include <vector>

#include <cable_variation/harness/topology.h>
#include <cable_variation/scene/cable_property.h>
#include <cable_variation/scene/deviations.h>
#include <cable_variation/scene/design_target.h>
#include <cable_variation/scene/measure_place.h>
#include <cable_variation/harness/clip_preset.h>
#include <cable_variation/util/name_list.h>

namespace cable_variation {

namespace {

template <typename Named>
std::size_t indexOf(const std::vector<Named>& all, const std::string& name, const char* kind) {
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (all[i].name == name) return i;
  }
  throw std::invalid_argument(std::string("no ") + kind + " named '" + name + "'");
}

/// What the harness has of the quantity that `target` sets; of a rest curvature, a factor, nothing.
std::optional<double> quantityOf(const Harness& harness, const DesignTarget& target) {
  if (const auto* clip = std::get_if<ClipArcLength>(&target)) return harness.clips[clip->clip].arc_length;
  if (const auto* joint = std::get_if<BreakoutArcLength>(&target)) {
    return harness.joints[joint->joint].parent_arc_length;
  }
  const auto* property = std::get_if<CableProperty>(&target);
  if (property == nullptr || property->property == CableProperty::Property::rest_curvature) return {};
  return propertyOf(harness.cables[property->cable], property->property);
}

/// Measures at the ends of cables are at those of `edited`.
void keepEnds(Scene& scene, const Harness& edited) {
  for (Measure& measure : scene.measures) {
    if (measure.cables.empty()) continue;
    const std::size_t cable = measure.cables.front();
    const double before = scene.harness.cables[cable].length, after = edited.cables[cable].length;
    for (double* place : {measure.arc_length ? &*measure.arc_length : nullptr, &measure.from, &measure.to}) {
      if (place != nullptr && isEnd(*place, before)) *place = after;
    }
  }
}

/// Makes `value` the scene's own for what `variable` sets, and for what follows from it.
void setQuantity(Scene& scene, const DesignVariable& variable, double value) {
  Scene edited = scene;
  edited.design_variables = {variable};
  edited.harness = harnessAt(edited, {{variable.name, value}});
  validate(edited.harness);
  for (DesignVariable& other : scene.design_variables) {
    if (const auto quantity = quantityOf(edited.harness, other.target)) other.nominal = *quantity;
    if (sameQuantity(other.target, variable.target)) other.nominal = value;
  }
  keepEnds(scene, edited.harness);
  scene.harness = std::move(edited.harness);
}

/// The scene's own variable of `target`, or one made for it.
DesignVariable variableOf(const Scene& scene, const DesignTarget& target, double nominal) {
  for (const DesignVariable& variable : scene.design_variables) {
    if (sameQuantity(variable.target, target)) return variable;
  }
  DesignVariable made;
  made.target = target;
  made.nominal = nominal;
  return made;
}

void requireFinite(const std::string& what, const Eigen::Vector3d& value) {
  if (!value.allFinite()) throw std::invalid_argument(what + " is not finite");
}

/// Its pose with an orientation that is one, of "clip 'A'".
Pose checkedPose(const std::string& what, const Pose& pose) {
  requireFinite("position of " + what, pose.position);
  const double norm = pose.orientation.norm();
  if (!(std::abs(norm - 1.0) < 1e-3)) {
    throw std::invalid_argument("quaternion of " + what + " has norm " + std::to_string(norm) +
                                ", expected 1");
  }
  return {pose.position, pose.orientation.normalized()};
}

/// The preset of a clip that is added, which its type names.
const ClipPresetTraits& addablePreset(const std::string& type) {
  std::vector<std::string> names;
  for (const ClipPresetTraits& traits : clipPresets()) {
    if (!canBeAdded(traits)) continue;
    if (type == traits.name) return traits;
    names.emplace_back(traits.name);
  }
  throw std::invalid_argument("type of a new clip '" + type + "'; expected one of " + joined(names));
}

Pose carrierOf(const Scene& scene, const std::string& component, const std::vector<ComponentFrame>& frames) {
  const std::size_t index = componentIndex(scene, component);
  return index == ComponentFrame::kWorld ? Pose() : frames[index].pose;
}

std::vector<ComponentFrame> framesOf(const Design& design, const ComponentPoses& moved) {
  return componentFrames(design.scene, deviationsOf(design.scene, design.shifted), moved);
}

}  // namespace

Harness harnessAt(const Design& design, const DesignValues& values, const ComponentPoses& moved) {
  DesignValues all = values;
  all.insert(design.shifted.begin(), design.shifted.end());
  return harnessAt(design.scene, all, moved);
}

ComponentPoses placesOf(const Design& design, const ComponentPoses& moved) {
  if (design.shifts.empty()) return moved;
  const Scene& scene = design.scene;
  ComponentPoses places;
  for (const Component& component : scene.components) {
    // from the world inwards: each ancestor's shift carries what rides on it
    std::vector<const Component*> chain{&component};
    while (chain.back()->parent != "world")
      chain.push_back(&scene.components[componentIndex(scene, chain.back()->parent)]);
    Pose carried;
    for (auto each = chain.rbegin(); each != chain.rend(); ++each) {
      const auto shift = design.shifts.find((*each)->name);
      if (shift == design.shifts.end()) continue;
      const Pose designed = componentPose(scene, (*each)->name, moved);
      carried = carried * designed * shift->second * designed.inverse();
    }
    places[component.name] = carried * componentPose(scene, component.name, moved);
  }
  return places;
}

Design withShiftsInScene(Design design) {
  Scene& scene = design.scene;
  for (const auto& [name, shift] : design.shifts) {
    Component& component = scene.components[componentIndex(scene, name)];
    component.pose = component.pose * shift;
    for (Motion& motion : scene.motions) {
      if (motion.component != name) continue;
      for (TimedPose& sample : motion.samples) sample.pose = sample.pose * shift;
    }
  }
  design.shifts.clear();
  for (std::size_t i = 0; i < scene.clip_mounts.size(); ++i) {
    const ClipMount& mount = scene.clip_mounts[i];
    scene.harness.clips[i].pose = componentPose(scene, mount.component) * mount.pose;
  }
  return design;
}

Scene sceneOf(const Design& design) {
  Scene scene = design.scene;
  const ComponentPoses places = placesOf(design, {});
  scene.harness = harnessAt(design, {}, places);
  const auto frames = framesOf(design, places);
  for (std::size_t i = 0; i < frames.size(); ++i) {
    const std::size_t parent = frames[i].parent;
    const Pose carrier = parent == ComponentFrame::kWorld ? Pose() : frames[parent].pose;
    scene.components[i].pose = carrier.inverse() * frames[i].pose;
  }
  for (std::size_t i = 0; i < scene.clip_mounts.size(); ++i) {
    ClipMount& mount = scene.clip_mounts[i];
    mount.pose = carrierOf(scene, mount.component, frames).inverse() * scene.harness.clips[i].pose;
  }
  for (DesignVariable& variable : scene.design_variables) {
    if (!setsQuantity(variable.target)) variable.nominal = 0.0;
  }
  return scene;
}

void setNominal(Design& design, const std::string& variable, double value) {
  const std::size_t index = indexOf(design.scene.design_variables, variable, "design variable");
  if (!std::isfinite(value)) {
    throw std::invalid_argument("design variable '" + variable + "': value is not finite");
  }
  DesignVariable& found = design.scene.design_variables[index];
  if (setsQuantity(found.target)) {
    setQuantity(design.scene, DesignVariable(found), value);
  } else {
    found.nominal = value;
    design.shifted[variable] = value;
  }
}

void setCableLength(Design& design, const std::string& cable, double length) {
  const std::size_t index = indexOf(design.scene.harness.cables, cable, "cable");
  DesignVariable edit = variableOf(design.scene, CableProperty{index, CableProperty::Property::length},
                                   design.scene.harness.cables[index].length);
  edit.name = "length of cable '" + cable + "'";
  setQuantity(design.scene, edit, length);
}

void setClipArcLength(Design& design, const std::string& clip, double arc_length) {
  const std::size_t index = indexOf(design.scene.harness.clips, clip, "clip");
  DesignVariable edit =
      variableOf(design.scene, ClipArcLength{index}, design.scene.harness.clips[index].arc_length);
  edit.name = "arc length of clip '" + clip + "'";
  setQuantity(design.scene, edit, arc_length);
}

void setClipPose(Design& design, const std::string& clip, const Pose& pose) {
  Scene& scene = design.scene;
  const std::size_t index = indexOf(scene.harness.clips, clip, "clip");
  ClipMount& mount = scene.clip_mounts[index];
  mount.pose = checkedPose("clip '" + clip + "'", pose);
  scene.harness.clips[index].pose = componentPose(scene, mount.component) * mount.pose;
}

void setAttached(Design& design, const std::string& clip, bool attached) {
  Harness harness = design.scene.harness;
  harness.clips[indexOf(harness.clips, clip, "clip")].attached = attached;
  makeTopology(harness);
  design.scene.harness = std::move(harness);
}

void setComponentPose(Design& design, const std::string& component, const Pose& pose) {
  const Component& part = design.scene.components[indexOf(design.scene.components, component, "component")];
  design.shifts[component] = part.pose.inverse() * checkedPose("component '" + component + "'", pose);
}

void addClip(Design& design, Clip clip, const ClipMount& mount) {
  Scene& scene = design.scene;
  const ClipPresetTraits& preset = addablePreset(clip.type);
  for (const Clip& other : scene.harness.clips) {
    if (other.name == clip.name)
      throw std::invalid_argument("there is a clip named '" + clip.name + "' already");
  }
  clip.constraint = preset.constraint({});
  const ClipMount checked{mount.component, checkedPose("clip '" + clip.name + "'", mount.pose)};
  clip.pose = componentPose(scene, checked.component) * checked.pose;
  Harness harness = scene.harness;
  harness.clips.push_back(std::move(clip));
  validate(harness);
  scene.harness = std::move(harness);
  scene.clip_mounts.push_back(checked);
}

void removeClip(Design& design, const std::string& clip) {
  Scene& scene = design.scene;
  const std::size_t index = indexOf(scene.harness.clips, clip, "clip");
  const auto later = [&](std::size_t other) { return other >= index; };
  bool is_free = true;
  for (const Measure& measure : scene.measures) is_free = is_free && !later(measure.clip);
  for (const DesignVariable& variable : scene.design_variables) {
    if (const auto* shift = std::get_if<ClipTranslation>(&variable.target))
      is_free = is_free && !later(shift->clip);
    if (const auto* turn = std::get_if<ClipRotation>(&variable.target))
      is_free = is_free && !later(turn->clip);
    if (const auto* at = std::get_if<ClipArcLength>(&variable.target)) is_free = is_free && !later(at->clip);
  }
  if (!is_free)
    throw std::invalid_argument("clip '" + clip + "' is the scene's own; expected one that was added");
  const auto offset = static_cast<std::ptrdiff_t>(index);
  scene.harness.clips.erase(scene.harness.clips.begin() + offset);
  scene.clip_mounts.erase(scene.clip_mounts.begin() + offset);
}

void placeClip(Design& design, const std::string& clip, const Pose& pose, const ComponentPoses& moved) {
  const std::size_t index = indexOf(design.scene.harness.clips, clip, "clip");
  const Deviations deviations = deviationsOf(design.scene, design.shifted);
  const auto frames = componentFrames(design.scene, deviations, moved);
  const Pose carrier = carrierOf(design.scene, design.scene.clip_mounts[index].component, frames);
  setClipPose(design, clip, carrier.inverse() * pose * deviations.clips[index].pose().inverse());
}

void placeComponent(Design& design, const std::string& component, const Pose& pose,
                    const ComponentPoses& moved) {
  const std::size_t index = indexOf(design.scene.components, component, "component");
  const ComponentFrame frame = framesOf(design, placesOf(design, moved))[index];
  const Pose deviated = frame.base.inverse() * frame.pose;
  const Pose base = checkedPose("component '" + component + "'", pose) * deviated.inverse();
  Pose& shift = design.shifts[component];
  shift = shift * frame.base.inverse() * base;
}

void moveClip(Design& design, const std::string& clip, const Eigen::Vector3d& translation,
              const Eigen::Vector3d& rotation) {
  requireFinite("translation of clip '" + clip + "'", translation);
  requireFinite("rotation of clip '" + clip + "'", rotation);
  const std::size_t index = indexOf(design.scene.harness.clips, clip, "clip");
  const double angle = rotation.norm();
  Pose step;
  step.position = translation;
  if (angle > 0.0) step.orientation = Eigen::AngleAxisd(angle, rotation / angle);
  setClipPose(design, clip, design.scene.clip_mounts[index].pose * step);
}

}  // namespace cable_variation
