#include <cable_variation/scene/target_name.h>

#include <variant>

#include <cable_variation/scene/enum_names.h>

namespace cable_variation {

namespace {

struct NameTarget {
  const Scene& scene;

  TargetName operator()(const ClipTranslation& t) const {
    return {"clip_translation", scene.harness.clips[t.clip].name, nameOf(t.axis)};
  }
  TargetName operator()(const ClipRotation& t) const {
    return {"clip_rotation", scene.harness.clips[t.clip].name, nameOf(t.axis)};
  }
  TargetName operator()(const ClipArcLength& t) const {
    return {"clip_arc_length", scene.harness.clips[t.clip].name, ""};
  }
  TargetName operator()(const CableProperty& t) const {
    return {"cable_property", scene.harness.cables[t.cable].name, nameOf(t.property)};
  }
  TargetName operator()(const BreakoutArcLength& t) const {
    return {"breakout_arc_length", scene.harness.joints[t.joint].name, ""};
  }
  TargetName operator()(const ComponentTranslation& t) const {
    return {"component_translation", scene.components[t.component].name, nameOf(t.axis)};
  }
  TargetName operator()(const ComponentRotation& t) const {
    return {"component_rotation", scene.components[t.component].name, nameOf(t.axis)};
  }
  TargetName operator()(const LocatorDeviation& t) const {
    return {"locator_deviation", scene.components[t.component].name, std::to_string(t.locator)};
  }
};

}  // namespace

TargetName nameOf(const DesignTarget& target, const Scene& scene) {
  return std::visit(NameTarget{scene}, target);
}

}  // namespace cable_variation
