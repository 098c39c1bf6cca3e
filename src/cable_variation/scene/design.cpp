#include <cable_variation/scene/design.h>

#include <cmath>
#include <optional>
#include <stdexcept>
#include <utility>

#include <cable_variation/harness/topology.h>
#include <cable_variation/scene/cable_property.h>
#include <cable_variation/scene/design_target.h>

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

}  // namespace

Harness harnessAt(const Design& design, const DesignValues& values, const ComponentPoses& moved) {
  DesignValues all = values;
  all.insert(design.shifted.begin(), design.shifted.end());
  return harnessAt(design.scene, all, moved);
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
  requireFinite("position of clip '" + clip + "'", pose.position);
  const double norm = pose.orientation.norm();
  if (!(std::abs(norm - 1.0) < 1e-3)) {
    throw std::invalid_argument("quaternion of clip '" + clip + "' has norm " + std::to_string(norm) +
                                ", expected 1");
  }
  ClipMount& mount = scene.clip_mounts[index];
  mount.pose = {pose.position, pose.orientation.normalized()};
  scene.harness.clips[index].pose = componentPose(scene, mount.component) * mount.pose;
}

void setAttached(Design& design, const std::string& clip, bool attached) {
  Harness harness = design.scene.harness;
  harness.clips[indexOf(harness.clips, clip, "clip")].attached = attached;
  makeTopology(harness);
  design.scene.harness = std::move(harness);
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
