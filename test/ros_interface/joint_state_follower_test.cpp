// Joint states put the links of a robot where its joints have them, and what is wrong with them is told once.
#include <ros_interface/live/joint_state_follower.h>

#include <cmath>
#include <limits>
#include <stdexcept>

#include <gtest/gtest.h>

namespace cable_variation_ros {
namespace {

using cable_variation::Component;
using cable_variation::ComponentDriver;
using cable_variation::LinkJoint;
using Transforms = std::vector<geometry_msgs::TransformStamped>;

ros::Time at(double seconds) { return ros::Time(1e9 + seconds); }

Component link(const std::string& name, const std::string& parent, LinkJoint joint) {
  Component component;
  component.name = "arm/" + name;
  component.parent = parent;
  component.driven_by = ComponentDriver::joint_states;
  component.robot = "arm";
  component.pose = linkPose(joint, 0.0);
  component.joint = joint;
  return component;
}

/// An arm that turns about z, 1 m up; on it a finger that slides along x, and a thumb that does the contrary.
cable_variation::Scene arm() {
  LinkJoint shoulder;
  shoulder.name = shoulder.driver = "shoulder";
  shoulder.type = LinkJoint::Type::revolute;
  shoulder.axis = Eigen::Vector3d::UnitZ();
  shoulder.origin.position = {0.0, 0.0, 1.0};
  shoulder.lower = -2.0;
  shoulder.upper = 2.0;
  LinkJoint grip;
  grip.name = grip.driver = "grip";
  grip.type = LinkJoint::Type::prismatic;
  grip.origin.position = {0.5, 0.0, 0.0};
  LinkJoint counter = grip;
  counter.name = "counter";
  counter.multiplier = -2.0;
  counter.offset = 0.001;
  LinkJoint mount;
  mount.name = mount.driver = "mount";
  cable_variation::Scene scene;
  scene.components.resize(1);
  scene.components[0].name = "arm";
  scene.components.push_back(link("upper", "arm", shoulder));
  scene.components.push_back(link("finger", "arm/upper", grip));
  scene.components.push_back(link("thumb", "arm/upper", counter));
  scene.components.push_back(link("camera", "arm/upper", mount));
  return scene;
}

sensor_msgs::JointState state(double seconds, const std::vector<std::string>& names,
                              const std::vector<double>& positions) {
  sensor_msgs::JointState message;
  message.header.stamp = at(seconds);
  message.name = names;
  message.position = positions;
  return message;
}

const geometry_msgs::TransformStamped& named(const Transforms& transforms, const std::string& name) {
  for (const auto& transform : transforms) {
    if (transform.child_frame_id == name) return transform;
  }
  throw std::out_of_range(name);
}

TEST(JointStateFollower, LinksAndThoseThatMimicAreWhereTheirJointsAre) {
  JointStateFollower follower(arm());
  std::vector<std::string> warnings;
  const Transforms moved =
      follower.take(state(1.0, {"grip", "shoulder"}, {0.02, M_PI / 2}), at(1.1), warnings);
  EXPECT_EQ(warnings, std::vector<std::string>());
  ASSERT_EQ(moved.size(), 3u);
  const auto& upper = named(moved, "arm/upper");
  EXPECT_EQ(upper.header.frame_id, "arm");
  EXPECT_EQ(upper.header.stamp, at(1.0));
  EXPECT_NEAR(upper.transform.translation.z, 1.0, 1e-12);
  EXPECT_NEAR(upper.transform.rotation.z, std::sin(M_PI / 4), 1e-12);
  EXPECT_NEAR(named(moved, "arm/finger").transform.translation.x, 0.52, 1e-12);
  EXPECT_NEAR(named(moved, "arm/thumb").transform.translation.x, 0.5 - 0.04 + 0.001, 1e-12);
}

TEST(JointStateFollower, UntilAJointIsHeardOfItsLinksStayWhereTheSceneHasThem) {
  JointStateFollower follower(arm());
  std::vector<std::string> warnings;
  EXPECT_EQ(follower.waiting(at(0.0)).size(), 3u);
  EXPECT_EQ(follower.unheard(), (std::vector<std::string>{"grip", "shoulder"}));
  follower.take(state(1.0, {"shoulder"}, {0.1}), at(1.0), warnings);
  const Transforms waiting = follower.waiting(at(1.0));
  ASSERT_EQ(waiting.size(), 2u);
  EXPECT_NEAR(named(waiting, "arm/thumb").transform.translation.x, 0.501, 1e-12);
  EXPECT_EQ(follower.unheard(), std::vector<std::string>{"grip"});
}

// A message waits for its turn: where the scene has the joint was told of with a later stamp. It may be the
// last one.
TEST(JointStateFollower, WhatIsHeardFirstIsNewerThanWhereTheSceneHasIt) {
  JointStateFollower follower(arm());
  std::vector<std::string> warnings;
  follower.waiting(at(1.02));
  EXPECT_GT(follower.take(state(1.01, {"shoulder"}, {0.1}), at(1.03), warnings).at(0).header.stamp, at(1.02));
  for (const auto& transform : follower.waiting(at(1.04))) EXPECT_NE(transform.child_frame_id, "arm/upper");
  EXPECT_EQ(follower.take(state(1.05, {"shoulder"}, {0.2}), at(1.06), warnings).at(0).header.stamp, at(1.05));
  // set back, it is where the scene has it, until it is heard again
  follower.take(state(0.5, {"grip"}, {0.0}), at(0.5), warnings);
  follower.waiting(at(0.6));
  EXPECT_GT(follower.take(state(0.59, {"shoulder"}, {0.1}), at(0.61), warnings).at(0).header.stamp, at(0.6));
}

TEST(JointStateFollower, AStampCountsOnceUntilTheClockIsSetBack) {
  JointStateFollower follower(arm());
  std::vector<std::string> warnings;
  EXPECT_EQ(follower.take(state(1.0, {"shoulder"}, {0.1}), at(1.0), warnings).size(), 1u);
  EXPECT_TRUE(follower.take(state(1.0, {"shoulder"}, {0.2}), at(1.1), warnings).empty());
  EXPECT_TRUE(follower.take(state(0.9, {"shoulder"}, {0.2}), at(1.2), warnings).empty());
  EXPECT_EQ(follower.take(state(1.0, {"grip"}, {0.2}), at(1.3), warnings).size(), 2u);
  EXPECT_EQ(follower.take(state(0.1, {"shoulder"}, {0.2}), at(0.1), warnings).size(), 1u);
  sensor_msgs::JointState without = state(0.0, {"shoulder"}, {0.2});
  without.header.stamp = ros::Time();
  EXPECT_EQ(follower.take(without, at(0.2), warnings).at(0).header.stamp, at(0.2));
}

TEST(JointStateFollower, WhatIsWrongIsToldOnce) {
  JointStateFollower follower(arm());
  std::vector<std::string> warnings;
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const double t : {1.0, 2.0}) {
    EXPECT_TRUE(follower.take(state(t, {"sholder", "grip"}, {0.0, nan}), at(t), warnings).empty());
    EXPECT_EQ(
        follower.take(state(t, {"shoulder", "mount", "counter"}, {2.5, 0.0, 9.0}), at(t), warnings).size(),
        1u);
    EXPECT_TRUE(follower.take(state(t + 0.1, {"shoulder"}, {0.0, 1.0}), at(t), warnings).empty());
    EXPECT_TRUE(follower.take(state(t + 0.1, {"shoulder"}, {}), at(t), warnings).empty());  // efforts, say
  }
  EXPECT_EQ(warnings, (std::vector<std::string>{
                          "joint 'sholder' is of no robot in the scene; did you mean 'shoulder'?",
                          "joint 'grip' is at nan; expected a finite position: it stays where it was",
                          "joint 'shoulder' is at 2.5, out of its limits -2 to 2; it is followed",
                          "a message has 2 positions for 1 joints; expected as many"}));
}

}  // namespace
}  // namespace cable_variation_ros
