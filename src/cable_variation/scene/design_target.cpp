#include <cable_variation/scene/design_target.h>

namespace cable_variation {

bool setsQuantity(const DesignTarget& target) {
  return std::holds_alternative<ClipArcLength>(target) || std::holds_alternative<CableProperty>(target) ||
         std::holds_alternative<BreakoutArcLength>(target);
}

bool sameQuantity(const DesignTarget& a, const DesignTarget& b) {
  if (a.index() != b.index()) return false;
  if (const auto* clip = std::get_if<ClipArcLength>(&a)) return clip->clip == std::get<ClipArcLength>(b).clip;
  if (const auto* joint = std::get_if<BreakoutArcLength>(&a)) {
    return joint->joint == std::get<BreakoutArcLength>(b).joint;
  }
  const auto* property = std::get_if<CableProperty>(&a);
  return property != nullptr && property->cable == std::get<CableProperty>(b).cable &&
         property->property == std::get<CableProperty>(b).property;
}

}  // namespace cable_variation
