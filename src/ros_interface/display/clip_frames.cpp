#include <ros_interface/display/clip_frames.h>

#include <vector>

#include <cable_variation/harness/clip_preset.h>
#include <ros_interface/context/solver_context.h>
#include <ros_interface/conversion/clip_frame.h>
#include <ros_interface/conversion/message_conversion.h>
#include <ros_interface/conversion/same_poses.h>

namespace cable_variation_ros {

using cable_variation::Pose;

void ClipFrames::publish(const SolverContext& context) {
  if (design_number_ == context.designNumber()) return;
  design_number_ = context.designNumber();
  const cable_variation::Scene& scene = context.design().scene;
  std::vector<geometry_msgs::TransformStamped> changed;
  for (std::size_t i = 0; i < scene.clip_mounts.size(); ++i) {
    const cable_variation::Clip& clip = context.harness().clips[i];
    if (!isMounted(clip)) continue;
    const std::string& parent = scene.clip_mounts[i].component;
    // tf has components as designed: their deviations and shifts are the clip's
    const Pose pose = componentPose(scene, parent, context.onTf()).inverse() * clip.pose;
    const std::string frame = clipFrame(scene, clip.name);
    const auto known = sent_.find(frame);
    if (known != sent_.end() && known->second.first == parent && same(known->second.second, pose)) continue;
    sent_[frame] = {parent, pose};
    changed.push_back(toTransform(pose, parent, frame, context.stamp()));
  }
  if (!changed.empty()) broadcaster_.sendTransform(changed);
}

}  // namespace cable_variation_ros
