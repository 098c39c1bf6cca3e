#include <cable_variation/scene/link_joint.h>

namespace cable_variation {

double jointPosition(const LinkJoint& joint, double driver_position) {
  return joint.multiplier * driver_position + joint.offset;
}

Pose jointMotion(const LinkJoint& joint, double position) {
  Pose motion;
  if (joint.type == LinkJoint::Type::prismatic) motion.position = position * joint.axis;
  if (joint.type == LinkJoint::Type::revolute) motion.orientation = Eigen::AngleAxisd(position, joint.axis);
  return motion;
}

Pose linkPose(const LinkJoint& joint, double driver_position) {
  return joint.origin * jointMotion(joint, jointPosition(joint, driver_position));
}

}  // namespace cable_variation
