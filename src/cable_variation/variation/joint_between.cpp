#include <cable_variation/variation/joint_between.h>

namespace cable_variation {

std::optional<JointBetween> jointBetween(const Harness& harness, std::size_t first, std::size_t second) {
  for (std::size_t i = 0; i < harness.joints.size(); ++i) {
    const Joint& joint = harness.joints[i];
    if (joint.parent == first && joint.child == second)
      return JointBetween{i, true, joint.parent_arc_length, joint.child_arc_length};
    if (joint.parent == second && joint.child == first)
      return JointBetween{i, false, joint.child_arc_length, joint.parent_arc_length};
  }
  return std::nullopt;
}

}  // namespace cable_variation
