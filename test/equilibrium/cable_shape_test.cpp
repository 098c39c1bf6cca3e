// Interpolation between a shape's solved sections.

#include <stdexcept>

#include <gtest/gtest.h>

#include <equilibrium/cases.h>

namespace cable_variation::test {
namespace {

constexpr double kRadius = 0.1, kClimb = 0.05;

// A helix with the frame that follows it: tangent along x, towards the axis along y.
ShapePoint helixPoint(double s) {
  const double per_radian = std::hypot(kRadius, kClimb);
  const double t = s / per_radian;
  ShapePoint point;
  point.arc_length = s;
  point.pose.position = {kRadius * std::cos(t), kRadius * std::sin(t), kClimb * t};
  point.tangent = Eigen::Vector3d(-kRadius * std::sin(t), kRadius * std::cos(t), kClimb) / per_radian;
  point.second_derivative =
      -kRadius / (per_radian * per_radian) * Eigen::Vector3d(std::cos(t), std::sin(t), 0.0);
  Eigen::Matrix3d frame;
  frame.col(0) = point.tangent;
  frame.col(1) = point.second_derivative.normalized();
  frame.col(2) = frame.col(0).cross(frame.col(1));
  point.pose.orientation = Eigen::Quaterniond(frame);
  point.darboux = {kClimb / (per_radian * per_radian), 0.0, kRadius / (per_radian * per_radian)};
  return point;
}

CableShape helix(int pieces) {
  CableShape shape;
  shape.cable = "helix";
  for (int i = 0; i <= pieces; ++i) shape.points.push_back(helixPoint(0.4 * i / pieces));
  return shape;
}

struct Deviation {
  double position = 0.0, angle = 0.0;
};

Deviation deviationOf(const CableShape& shape) {
  Deviation largest;
  for (int i = 0; i <= 200; ++i) {
    const double s = 0.4 * i / 200;
    const Pose exact = helixPoint(s).pose, here = shape.pose(s);
    largest.position = std::max(largest.position, (here.position - exact.position).norm());
    largest.angle = std::max(largest.angle, angleBetween(here.orientation, exact.orientation));
    EXPECT_EQ(shape.position(s), here.position);
  }
  return largest;
}

// Quintic in position: order six. A helix turns evenly in its own frame, which the rotation meets exactly.
TEST(CableShape, InterpolatesPositionWithOrderSix) {
  const Deviation coarse = deviationOf(helix(4)), fine = deviationOf(helix(8));
  EXPECT_LT(coarse.position, 2e-6);
  EXPECT_GT(std::log2(coarse.position / fine.position), 5.5);
  EXPECT_LT(coarse.angle, 1e-12);
}

TEST(CableShape, KeepsWithinItsEnds) {
  const CableShape shape = helix(4);
  EXPECT_EQ(shape.position(-1.0), shape.points.front().pose.position);
  EXPECT_LT((shape.position(9.0) - shape.points.back().pose.position).norm(), 1e-15);
}

TEST(CableShape, TwoPointsAtOnePlaceLeaveNoGap) {
  CableShape shape = helix(4);
  shape.points.insert(shape.points.begin() + 2, shape.points[2]);
  const double s = shape.points[2].arc_length;
  for (double at : {s - 1e-9, s, s + 1e-9}) {
    EXPECT_LT((shape.position(at) - helixPoint(at).pose.position).norm(), 1e-12);
  }
  EXPECT_LT(deviationOf(shape).position, 2e-6);
}

TEST(CableShape, SamplesAtEqualSteps) {
  const CableShape shape = helix(6);
  const std::vector<Pose> poses = shape.sample(5);
  ASSERT_EQ(poses.size(), 5u);
  for (std::size_t i = 0; i < 5; ++i) {
    EXPECT_LT((poses[i].position - shape.position(0.1 * static_cast<double>(i))).norm(), 1e-15);
  }
  EXPECT_THROW(shape.sample(1), std::invalid_argument);
  EXPECT_THROW(CableShape().position(0.1), std::invalid_argument);
}

}  // namespace
}  // namespace cable_variation::test
