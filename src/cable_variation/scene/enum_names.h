#pragma once

#include <array>
#include <cstddef>

#include <cable_variation/harness/harness.h>
#include <cable_variation/scene/scene.h>

namespace cable_variation {

/// The name of an enumerator, from names in the enumerators' order.
template <typename Enum, std::size_t count>
const char* nameOf(Enum value, const std::array<const char*, count>& names) {
  return names.at(static_cast<std::size_t>(value));
}

// As in a scene file.
inline const char* nameOf(Axis axis) { return nameOf(axis, std::array<const char*, 3>{"x", "y", "z"}); }
inline const char* nameOf(ComponentDriver driver) {
  return nameOf(driver, std::array<const char*, 3>{"scene", "tf", "joint_states"});
}
inline const char* nameOf(Joint::Type type) {
  return nameOf(type, std::array<const char*, 3>{"fixed", "pivot", "hinge"});
}
inline const char* nameOf(CableProperty::Property property) {
  return nameOf(property, std::array<const char*, 7>{"length", "radius", "EI", "GJ", "EA", "density",
                                                     "rest_curvature"});
}
inline const char* nameOf(ToleranceRegion::Shape shape) {
  return nameOf(shape, std::array<const char*, 3>{"ball", "disc", "cone"});
}

}  // namespace cable_variation
