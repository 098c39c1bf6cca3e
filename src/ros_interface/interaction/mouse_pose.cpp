#include <ros_interface/interaction/mouse_pose.h>

#include <cmath>

#include <cable_variation/math/so3.h>

namespace cable_variation_ros {

namespace so3 = cable_variation::so3;

namespace {

constexpr double kStep = 1e-6;  // [m, rad]

// In the direction of each axis.
Eigen::Vector3d wholeSteps(const Eigen::Vector3d& change) {
  return change.unaryExpr([](double value) { return kStep * std::round(value / kStep); });
}

}  // namespace

cable_variation::Pose mousePose(const cable_variation::Pose& before, const cable_variation::Pose& wanted) {
  cable_variation::Pose meant = before;
  meant.position += wholeSteps(wanted.position - before.position);
  const Eigen::Vector3d turn = wholeSteps(so3::log(before.orientation.conjugate() * wanted.orientation));
  if (!turn.isZero(0.0)) meant.orientation = (before.orientation * so3::exp(turn)).normalized();
  return meant;
}

}  // namespace cable_variation_ros
