#include <ros_interface/conversion/design_request.h>

#include <utility>

#include <cable_variation/analysis/design_values.h>
#include <cable_variation/analysis/name_lookup.h>
#include <ros_interface/conversion/message_conversion.h>
#include <ros_interface/node/names.h>

namespace cable_variation_ros {

using cable_variation::Design;

namespace {

void add(const cable_variation::NewClip& asked, Design& design) {
  const cable_variation::Scene& scene = design.scene;
  if (!asked.component.empty() && asked.component != kWorldFrame)
    indexOf(asked.component, scene.components, "component");
  cable_variation::Clip clip;
  clip.name = asked.name;
  clip.type = asked.type;
  clip.cable = indexOf(asked.cable, scene.harness.cables, "cable");
  clip.arc_length = asked.arc_length;
  const cable_variation::Pose pose = fromPose(asked.pose, "clip '" + asked.name + "'");
  addClip(design, std::move(clip), {asked.component.empty() ? kWorldFrame : asked.component, pose});
}

void apply(const cable_variation::ClipEdit& edit, Design& design) {
  indexOf(edit.clip, design.scene.harness.clips, "clip");
  if (edit.set_pose) setClipPose(design, edit.clip, fromPose(edit.pose, "clip '" + edit.clip + "'"));
  moveClip(design, edit.clip, fromVector(edit.translation), fromVector(edit.rotation));
  if (edit.set_arc_length) setClipArcLength(design, edit.clip, edit.arc_length);
}

}  // namespace

Design edited(Design design, const cable_variation::SetDesignRequest& request) {
  for (const auto& [name, value] : toDesignValues(design.scene, request.variables, request.values)) {
    setNominal(design, name, value);
  }
  for (const cable_variation::CableEdit& edit : request.cables) {
    indexOf(edit.cable, design.scene.harness.cables, "cable");
    setCableLength(design, edit.cable, edit.length);
  }
  for (const cable_variation::ComponentEdit& edit : request.components) {
    indexOf(edit.component, design.scene.components, "component");
    setComponentPose(design, edit.component, fromPose(edit.pose, "component '" + edit.component + "'"));
  }
  for (const cable_variation::NewClip& clip : request.new_clips) add(clip, design);
  for (const cable_variation::ClipEdit& edit : request.clips) apply(edit, design);
  return design;
}

}  // namespace cable_variation_ros
