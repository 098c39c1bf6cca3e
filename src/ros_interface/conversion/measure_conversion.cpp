#include <ros_interface/conversion/measure_conversion.h>

#include <cable_variation/scene/enum_names.h>
#include <cable_variation/scene/measure_traits.h>
#include <ros_interface/conversion/message_conversion.h>

namespace cable_variation_ros {

using cable_variation::Measure;
using cable_variation::MeasureInfo;
using cable_variation::MeasureResult;
using cable_variation::MeasureTraits;
using cable_variation::MeasureValue;
using cable_variation::Scene;

namespace {

std::vector<std::string> namesOf(const std::vector<std::size_t>& cables, const Scene& scene) {
  std::vector<std::string> names;
  for (const std::size_t cable : cables) names.push_back(scene.harness.cables[cable].name);
  return names;
}

}  // namespace

MeasureInfo toInfo(const Measure& measure, const Scene& scene) {
  auto info = described<MeasureInfo>(measure);
  info.cables = namesOf(measure.cables, scene);
  if (measure.component) info.component = scene.components[*measure.component].name;
  info.other_cables = namesOf(measure.other_cables, scene);
  info.skip_near_clips = measure.skip_near_clips;
  info.skip_near_joints = measure.skip_near_joints;
  info.surface = measure.surface;
  info.at_one_place = measure.arc_length.has_value();
  info.arc_length = measure.arc_length.value_or(0.0);
  info.direction = toVector(measure.direction);
  if (measure.axis) info.axis = nameOf(*measure.axis);
  info.twist_start = measure.from;
  info.twist_end = measure.to;
  info.segment = measure.segment;
  if (traitsOf(measure.type).subject == MeasureTraits::Subject::clip)
    info.clip = scene.harness.clips[measure.clip].name;
  return info;
}

MeasureResult toResult(const Measure& measure, const MeasureValue& value, const Scene& scene) {
  auto result = described<MeasureResult>(measure);
  result.value = value.value;
  result.within = withinLimits(measure, value.value);
  result.note = value.note;
  result.unique = value.unique;
  result.has_place = value.has_place;
  if (value.has_place) {
    result.cable = scene.harness.cables[value.cable].name;
    result.arc_length = value.arc_length;
    result.point = toPoint(value.point);
  }
  result.has_other = value.has_other;
  if (value.has_other) result.other = toPoint(value.other);
  return result;
}

}  // namespace cable_variation_ros
