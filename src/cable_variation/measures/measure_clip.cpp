#include <cable_variation/measures/measure_clip.h>

#include <Eigen/Geometry>

namespace cable_variation {
namespace {

using Eigen::Vector3d;

MeasureValue atClip(const MeasureContext& context, const Measure& measure, double value) {
  const Reaction& reaction = context.at.equilibrium.clip_reactions.at(measure.clip);
  MeasureValue result;
  result.value = value;
  result.has_place = true;
  result.cable = context.at.harness.clips[measure.clip].cable;
  result.arc_length = reaction.arc_length;
  result.point = reaction.section.position;
  return result;
}

Vector3d loadOf(const Measure& measure, const Vector3d& force, const Vector3d& moment) {
  return measure.type == Measure::Type::clip_force ? force : moment;
}

Vector3d axisOf(const MeasureContext& context, const Measure& measure) {
  return context.at.harness.clips[measure.clip].pose.orientation *
         Vector3d::Unit(static_cast<int>(*measure.axis));
}

Vector3d loadOn(const MeasureContext& context, const Measure& measure) {
  const Reaction& reaction = context.at.equilibrium.clip_reactions.at(measure.clip);
  return loadOf(measure, reaction.force, reaction.moment);
}

}  // namespace

MeasureValue clipLoadValue(const MeasureContext& context, const Measure& measure) {
  const Vector3d load = loadOn(context, measure);
  if (measure.axis) return atClip(context, measure, axisOf(context, measure).dot(load));
  MeasureValue value = atClip(context, measure, load.norm());
  if (value.value == 0.0) markAsShared(value, "no load: it grows whichever way a variable goes");
  return value;
}

double clipLoadRate(const MeasureContext& context, const Measure& measure, const MeasureRates& rates) {
  const Vector3d load = loadOn(context, measure);
  const ReactionRate& reaction = rates.equilibrium.clip_reactions[measure.clip];
  const Vector3d rate = loadOf(measure, reaction.force, reaction.moment);
  if (!measure.axis) return load.isZero(0.0) ? rate.norm() : load.normalized().dot(rate);
  const Vector3d axis = axisOf(context, measure);
  double change = axis.dot(rate);
  for (const auto& [clip, frame] : rates.design.harness.clip_frames) {
    if (clip == measure.clip) change += frame.rotation.cross(axis).dot(load);
  }
  return change;
}

MeasureValue slideValue(const MeasureContext& context, const Measure& measure) {
  const double held = context.at.equilibrium.clip_reactions.at(measure.clip).arc_length;
  return atClip(context, measure, held - context.scene.harness.clips[measure.clip].arc_length);
}

double slideRate(const Measure& measure, const MeasureRates& rates) {
  return rates.equilibrium.clip_reactions[measure.clip].arc_length;
}

}  // namespace cable_variation
