// Which components move, and where they are while their motions play.
#include <cable_variation/scene/moving_components.h>

#include <cmath>
#include <stdexcept>

#include <gtest/gtest.h>

namespace cable_variation {
namespace {

Component componentIn(const std::string& name, const std::string& parent, const Eigen::Vector3d& position) {
  Component component;
  component.name = name;
  component.parent = parent;
  component.pose.position = position;
  return component;
}

Motion motionTo(const std::string& component, const Pose& end) {
  Motion motion;
  motion.name = component + "_run";
  motion.component = component;
  motion.samples = {{0.0, Pose()}, {1.0, end}};
  return motion;
}

/// A finger on an arm on a table, listed tip first; a floor that nothing moves.
Scene robot() {
  Scene scene;
  scene.components = {
      componentIn("finger", "arm", {0.0, 0.0, 0.1}), componentIn("arm", "table", {0.5, 0.0, 0.0}),
      componentIn("table", "world", {1.0, 0.0, 0.0}), componentIn("floor", "world", {0.0, 0.0, 0.0})};
  const Eigen::Quaterniond quarter(Eigen::AngleAxisd(M_PI / 2, Eigen::Vector3d::UnitZ()));
  scene.motions = {motionTo("arm", {{0.5, 0.0, 0.2}, Eigen::Quaterniond::Identity()}),
                   motionTo("table", {{1.0, 0.0, 0.0}, quarter})};
  return scene;
}

TEST(MovingComponents, ThoseWithAMotionAndThoseThatRideOnThem) {
  EXPECT_EQ(movingComponents(robot()), (std::set<std::string>{"arm", "finger", "table"}));
}

TEST(MovingComponents, AMotionOnAMotionAddsUp) {
  const Scene scene = robot();
  const ComponentPoses poses = posesDuring(scene, {&scene.motions[0], &scene.motions[1]}, 1.0);
  EXPECT_EQ(poses.size(), 2u);
  EXPECT_TRUE(poses.at("table").position.isApprox(Eigen::Vector3d(1.0, 0.0, 0.0), 1e-12));
  EXPECT_TRUE(poses.at("arm").position.isApprox(Eigen::Vector3d(1.0, 0.5, 0.2), 1e-12));
  EXPECT_TRUE(componentPose(scene, "finger", poses).position.isApprox(Eigen::Vector3d(1.0, 0.5, 0.3), 1e-12));
}

TEST(MovingComponents, AMotionAloneLeavesTheOthersInTheirPlace) {
  const Scene scene = robot();
  const ComponentPoses poses = posesDuring(scene, {&scene.motions[0]}, 0.5);
  EXPECT_TRUE(poses.at("arm").position.isApprox(Eigen::Vector3d(1.25, 0.0, 0.1), 1e-12));
}

TEST(MovingComponents, WhatTfDrivesIsMovedByNoMotion) {
  Scene scene = robot();
  scene.components[2].driven_by = ComponentDriver::tf;  // the table
  EXPECT_EQ(movingComponents(scene), (std::set<std::string>{"arm", "finger"}));
  EXPECT_FALSE(movesItself(scene, scene.components[2]));
}

TEST(MovingComponents, TheJointsOfARobotMoveItsLinksAndWhatTheyCarry) {
  const auto link = [](const std::string& name, const std::string& parent, LinkJoint::Type type) {
    Component component = componentIn(name, parent, {0.1, 0.0, 0.0});
    component.driven_by = ComponentDriver::joint_states;
    component.robot = "arm";
    component.joint.emplace();
    component.joint->type = type;
    return component;
  };
  Scene scene;
  scene.components = {componentIn("arm", "world", {0.0, 0.0, 0.0}),
                      link("arm/foot", "arm", LinkJoint::Type::fixed),
                      link("arm/upper", "arm", LinkJoint::Type::revolute),
                      link("arm/hand", "arm/upper", LinkJoint::Type::fixed),
                      componentIn("plug", "arm/hand", {0.0, 0.0, 0.0}),
                      componentIn("floor", "world", {0.0, 0.0, 0.0})};
  scene.components[0].robot = "arm";
  EXPECT_EQ(movingComponents(scene), (std::set<std::string>{"arm/upper", "arm/hand", "plug"}));
  EXPECT_EQ(bodiesOf(scene, 0), (std::vector<std::size_t>{0, 1, 2, 3}));
  EXPECT_EQ(bodiesOf(scene, 2), (std::vector<std::size_t>{2}));
  EXPECT_EQ(bodiesOf(scene, 4), (std::vector<std::size_t>{4}));
  EXPECT_TRUE(sameRobot(scene.components[0], scene.components[3]));
  EXPECT_FALSE(sameRobot(scene.components[4], scene.components[3]));
  EXPECT_FALSE(sameRobot(scene.components[4], scene.components[5]));
}

TEST(MovingComponents, AMotionThatIsNotLoadedIsRefused) {
  Scene scene = robot();
  scene.motions[0].samples.clear();
  EXPECT_THROW(posesDuring(scene, {&scene.motions[0]}, 0.0), std::invalid_argument);
}

}  // namespace
}  // namespace cable_variation
