#include <cable_variation/harness/harness_rate.h>

#include <cable_variation/harness/harness.h>
#include <cable_variation/math/so3.h>

namespace cable_variation {
namespace {

void change(Section& section, const CableRate& rate, double step) {
  double* const stiffness[] = {&section.EA, &section.GA_y, &section.GA_z,
                               &section.GJ, &section.EI_y, &section.EI_z};
  for (int k = 0; k < 6; ++k) *stiffness[k] *= 1.0 + step * rate.stiffness[k];
  section.mass_per_length *= 1.0 + step * rate.mass;
  section.radius *= 1.0 + step * rate.radius;
}

void move(Pose& pose, const FrameRate& frame, double step) {
  pose.position += step * frame.translation;
  pose.orientation = (so3::exp(step * frame.rotation) * pose.orientation).normalized();
}

}  // namespace

Harness changed(const Harness& harness, const HarnessRate& rate, double step) {
  Harness result = harness;
  for (const auto& [clip, frame] : rate.clip_frames) move(result.clips[clip].pose, frame, step);
  for (const auto& [contact, frame] : rate.part_frames) move(result.contacts[contact].pose, frame, step);
  for (const auto& [clip, value] : rate.clip_arc_lengths) result.clips[clip].arc_length += step * value;
  for (const auto& [joint, value] : rate.parent_arc_lengths) {
    result.joints[joint].parent_arc_length += step * value;
  }
  for (const auto& [joint, value] : rate.child_arc_lengths) {
    result.joints[joint].child_arc_length += step * value;
  }
  for (const auto& [load, value] : rate.load_arc_lengths) result.loads[load].arc_length += step * value;
  for (const CableRate& rates : rate.cables) {
    Cable& cable = result.cables[rates.cable];
    cable.length += step * rates.length;
    for (SectionAt& knot : cable.sections) {
      knot.arc_length *= 1.0 + step * rates.knots;
      change(knot.section, rates, step);
    }
    for (RestCurvatureAt& knot : cable.rest_curvature) {
      knot.arc_length *= 1.0 + step * rates.knots;
      knot.curvature *= 1.0 + step * rates.rest_curvature;
    }
  }
  return result;
}

}  // namespace cable_variation
