// Messages carry what the core's types hold, and bad poses do not get in.
#include <ros_interface/conversion/message_conversion.h>

#include <cmath>

#include <gtest/gtest.h>

namespace cable_variation_ros {
namespace {

using cable_variation::CableShape;
using cable_variation::Equilibrium;
using cable_variation::EquilibriumStatus;
using cable_variation::Harness;
using cable_variation::Pose;
using cable_variation::ShapePoint;

TEST(MessageConversion, APoseComesBackAsItWent) {
  Pose pose;
  pose.position = {0.1, -0.2, 0.3};
  pose.orientation = Eigen::Quaterniond(Eigen::AngleAxisd(0.7, Eigen::Vector3d(1, 2, 3).normalized()));
  const Pose back = fromPose(toPose(pose), "pose");
  EXPECT_EQ(back.position, pose.position);
  EXPECT_LT(back.orientation.angularDistance(pose.orientation), 1e-12);
  const geometry_msgs::TransformStamped transform = toTransform(pose, "parent", "child", ros::Time(3));
  EXPECT_EQ(transform.header.frame_id, "parent");
  EXPECT_EQ(transform.child_frame_id, "child");
  EXPECT_EQ(fromTransform(transform.transform, "pose").position, pose.position);
}

TEST(MessageConversion, AQuaternionOfFewDigitsIsMadeAUnitOne) {
  geometry_msgs::Pose message;
  message.orientation.z = message.orientation.w = 0.7073;  // 0.03 % too long
  EXPECT_NEAR(fromPose(message, "pose").orientation.norm(), 1.0, 1e-15);
}

TEST(MessageConversion, RefusesPosesThatAreNone) {
  geometry_msgs::Pose pose;
  EXPECT_THROW(fromPose(pose, "zero quaternion"), std::invalid_argument);
  pose.orientation.w = 1.01;
  EXPECT_THROW(fromPose(pose, "long quaternion"), std::invalid_argument);
  pose.orientation.w = std::nan("");
  EXPECT_THROW(fromPose(pose, "quaternion"), std::invalid_argument);
  pose.orientation.w = 1.0;
  pose.position.y = INFINITY;
  EXPECT_THROW(fromPose(pose, "position"), std::invalid_argument);
}

/// A quarter circle of radius 0.2 m about z, its figures told apart by their values.
Equilibrium quarterCircle() {
  CableShape shape;
  shape.cable = "bow";
  shape.radius = 0.004;
  for (int i = 0; i <= 10; ++i) {
    const double angle = 0.05 * M_PI * i;
    ShapePoint point;
    point.arc_length = 0.2 * angle;
    point.pose.position = 0.2 * Eigen::Vector3d(std::sin(angle), 1.0 - std::cos(angle), 0.0);
    point.pose.orientation = Eigen::AngleAxisd(angle, Eigen::Vector3d::UnitZ());
    point.tangent = point.pose.orientation * Eigen::Vector3d::UnitX();
    point.second_derivative = point.pose.orientation * Eigen::Vector3d(0.0, 5.0, 0.0);
    point.darboux = {0.0, 0.0, 5.0};
    point.force = {1.0, 2.0, i * 1.0};
    point.moment = {4.0, 5.0, i * 2.0};
    point.strain = {7.0, 8.0, i * 3.0};
    point.curvature = {10.0, 11.0, i * 4.0};
    shape.points.push_back(point);
  }
  Equilibrium equilibrium;
  equilibrium.status = EquilibriumStatus::converged;
  equilibrium.shapes = {shape};
  equilibrium.clip_reactions.resize(1);
  equilibrium.clip_reactions[0].name = "clip";
  equilibrium.clip_reactions[0].force = {1.0, 2.0, 3.0};
  equilibrium.clip_reactions[0].arc_length = 0.12;
  equilibrium.energy = {1.0, 2.0, 4.0, 8.0};
  equilibrium.alternatives = {{3.0, 0.5}};
  return equilibrium;
}

Harness bowHarness() {
  Harness harness;
  harness.cables.resize(1);
  harness.cables[0].name = "bow";
  harness.cables[0].length = 0.1 * M_PI;
  harness.clips.resize(1);
  return harness;
}

TEST(MessageConversion, AnEquilibriumIsToldWhole) {
  const cable_variation::SolveEquilibriumResponse response = toResponse(quarterCircle(), bowHarness());
  ASSERT_EQ(response.shapes.size(), 1u);
  const cable_variation::CableState& state = response.shapes[0];
  EXPECT_EQ(state.cable, "bow");
  EXPECT_EQ(state.length, 0.1 * M_PI);
  EXPECT_NEAR(state.smallest_bend_radius, 0.2, 1e-5);
  ASSERT_EQ(state.centreline.size(), 159u);  // 314 mm in steps of at most 2 mm
  for (const geometry_msgs::Point& point : state.centreline) {
    EXPECT_NEAR(std::hypot(point.x, point.y - 0.2), 0.2, 1e-6);
  }
  ASSERT_EQ(state.section.size(), 11u);
  EXPECT_NEAR(state.section[10].position.x, 0.2, 1e-15);
  EXPECT_EQ(state.force[3].z, 3.0);
  EXPECT_EQ(state.moment[3].z, 6.0);
  EXPECT_EQ(state.strain[3].z, 9.0);
  EXPECT_EQ(state.curvature[3].z, 12.0);
  ASSERT_EQ(response.clip_reactions.size(), 1u);
  EXPECT_EQ(response.clip_reactions[0].clip, "clip");
  EXPECT_EQ(response.clip_reactions[0].cable, "bow");
  EXPECT_EQ(response.clip_reactions[0].force.z, 3.0);
  EXPECT_EQ(response.clip_reactions[0].arc_length, 0.12);
  EXPECT_EQ(response.energy.springs, 4.0);
  EXPECT_EQ(response.energy.total, 15.0);
  ASSERT_EQ(response.alternatives.size(), 1u);
  EXPECT_EQ(response.alternatives[0].largest_distance, 0.5);
}

TEST(MessageConversion, WhatTouchesIsToldWithItsPlaces) {
  Equilibrium equilibrium = quarterCircle();
  EXPECT_TRUE(std::isinf(toResponse(equilibrium, bowHarness()).smallest_gap));
  cable_variation::ContactInterval interval;
  interval.part = "post";
  interval.start = 0.1;
  interval.end = 0.2;
  interval.force = {0.0, 3.0, 4.0};
  interval.moment = {1.0, 2.0, 3.0};
  interval.total = 6.0;
  interval.places = {{0.1, {1.0, 2.0, 3.0}, {0.0, 0.6, 0.8}, 5.0},
                     {0.2, {4.0, 5.0, 6.0}, {0.0, 0.0, 1.0}, 1.0}};
  equilibrium.contacts = {interval};
  equilibrium.smallest_gap = -1e-6;
  const cable_variation::SolveEquilibriumResponse response = toResponse(equilibrium, bowHarness());
  EXPECT_EQ(response.smallest_gap, -1e-6);
  ASSERT_EQ(response.contacts.size(), 1u);
  const cable_variation::CableContact& contact = response.contacts[0];
  EXPECT_EQ(contact.cable, "bow");
  EXPECT_EQ(contact.component, "post");
  EXPECT_EQ(contact.start, 0.1);
  EXPECT_EQ(contact.end, 0.2);
  EXPECT_EQ(fromVector(contact.force), interval.force);
  EXPECT_EQ(fromVector(contact.moment), interval.moment);
  EXPECT_EQ(contact.total, 6.0);
  ASSERT_EQ(contact.arc_length.size(), 2u);
  ASSERT_EQ(contact.on_component.size(), 2u);
  ASSERT_EQ(contact.place_force.size(), 2u);
  EXPECT_EQ(contact.arc_length[1], 0.2);
  EXPECT_EQ(contact.on_component[0].y, 2.0);
  EXPECT_TRUE(fromVector(contact.place_force[0]).isApprox(Eigen::Vector3d(0.0, 3.0, 4.0)));
}

TEST(MessageConversion, AShapeThatIsNoEquilibriumIsNotTold) {
  Equilibrium equilibrium = quarterCircle();
  equilibrium.status = EquilibriumStatus::unstable;
  EXPECT_TRUE(toCableShapes(equilibrium, bowHarness(), ros::Time()).cables.empty());
}

TEST(MessageConversion, AWrenchIsInTheAxesOfItsClipAndAboutItsOrigin) {
  cable_variation::Reaction reaction;
  reaction.force = {1.0, 2.0, 3.0};
  reaction.moment = {0.1, 0.2, 0.3};
  reaction.section.position = {0.4, 0.0, 0.0};  // the section has gone 0.4 m along the clip's y
  Pose clip;
  clip.orientation = Eigen::AngleAxisd(-M_PI / 2, Eigen::Vector3d::UnitZ());
  const geometry_msgs::Wrench wrench = toWrench(reaction, clip);
  EXPECT_TRUE(fromVector(wrench.force).isApprox(Eigen::Vector3d(-2.0, 1.0, 3.0)));
  // about the origin: (0.1, 0.2, 0.3) + (0.4, 0, 0) x (1, 2, 3) = (0.1, -1.0, 1.1), in the clip's axes
  EXPECT_TRUE(fromVector(wrench.torque).isApprox(Eigen::Vector3d(1.0, 0.1, 1.1)));
}

}  // namespace
}  // namespace cable_variation_ros
