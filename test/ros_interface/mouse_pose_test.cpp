// What is dragged in RViz, which calculates in single precision, changes where it was dragged and nowhere
// else.
#include <ros_interface/interaction/mouse_pose.h>

#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include <cable_variation/math/so3.h>

namespace cable_variation_ros {
namespace {

using cable_variation::Pose;
using Eigen::Vector3d;
namespace so3 = cable_variation::so3;

class MousePose : public testing::Test {
 protected:
  double within(double most) { return std::uniform_real_distribution<>(-most, most)(random_); }
  Vector3d anywhere(double most) { return {within(most), within(most), within(most)}; }
  /// As RViz has it.
  static Pose inSinglePrecision(const Pose& pose) {
    return {pose.position.cast<float>().cast<double>(),
            pose.orientation.cast<float>().cast<double>().normalized()};
  }

  std::mt19937 random_{5};
};

TEST_F(MousePose, WhatIsNotDraggedStaysToTheLastBit) {
  for (int i = 0; i < 1000; ++i) {
    const Pose before{anywhere(2.0), so3::exp(anywhere(1.5))};
    const Pose after = mousePose(before, inSinglePrecision(before));
    EXPECT_EQ(after.position, before.position);
    EXPECT_EQ(after.orientation.coeffs(), before.orientation.coeffs());
  }
}

TEST_F(MousePose, AMoveAlongAnAxisMovesAlongItAlone) {
  for (int i = 0; i < 1000; ++i) {
    const Pose before{anywhere(2.0), so3::exp(anywhere(1.5))};
    Pose wanted = before;
    const int axis = i % 3;
    const double micrometres = std::round(within(1e5));
    wanted.position[axis] += 1e-6 * micrometres;
    const Pose after = mousePose(before, inSinglePrecision(wanted));
    for (int k = 0; k < 3; ++k) {
      EXPECT_NEAR(after.position[k], wanted.position[k], k == axis ? 1e-12 : 0.0) << micrometres;
    }
    EXPECT_EQ(after.orientation.coeffs(), before.orientation.coeffs());
  }
}

TEST_F(MousePose, ATurnIsFollowedToAMicroradian) {
  for (int i = 0; i < 1000; ++i) {
    const Pose before{anywhere(2.0), so3::exp(anywhere(1.5))};
    const Pose wanted{before.position, before.orientation * so3::exp(anywhere(1.5))};
    const Pose after = mousePose(before, inSinglePrecision(wanted));
    EXPECT_EQ(after.position, before.position);
    EXPECT_LT(after.orientation.angularDistance(wanted.orientation), 2e-6);
  }
}

}  // namespace
}  // namespace cable_variation_ros
