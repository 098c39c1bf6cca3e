#include <ros_interface/markers/labels.h>

#include <cable_variation/harness/clip_preset.h>
#include <ros_interface/conversion/message_conversion.h>

namespace cable_variation_ros {

using cable_variation::Label;

std::vector<Label> clipLabels(const cable_variation::Equilibrium& equilibrium,
                              const cable_variation::Harness& harness) {
  std::vector<Label> labels;
  for (std::size_t i = 0; i < harness.clips.size(); ++i) {
    const cable_variation::Clip& clip = harness.clips[i];
    if (!isMounted(clip) && !equilibrium.converged()) continue;
    const cable_variation::Pose& pose = isMounted(clip) ? clip.pose : equilibrium.clip_reactions[i].section;
    Label label;
    label.kind = Label::NAME;
    label.text = clip.attached ? clip.name : clip.name + " (open)";
    label.at = toPoint(pose.position);
    labels.push_back(label);
  }
  return labels;
}

std::vector<Label> distanceLabels(const std::vector<DistanceMark>& marks) {
  std::vector<Label> labels;
  for (const DistanceMark& mark : marks) {
    Label label;
    label.kind = mark.interferes ? Label::FAULT : Label::FIGURE;
    label.text = mark.text;
    label.at = toPoint(mark.point);
    labels.push_back(label);
  }
  return labels;
}

}  // namespace cable_variation_ros
