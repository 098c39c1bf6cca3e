// Components that the design moves: where they are in their frames, and the way there by message.
#include <ros_interface/conversion/component_deviations.h>

#include <cmath>

#include <gtest/gtest.h>

#include <ros_interface/markers/component_markers.h>

namespace cable_variation_ros {
namespace {

using namespace cable_variation;

Pose poseOf(const Eigen::Vector3d& position, double angle, const Eigen::Vector3d& axis) {
  return {position, Eigen::Quaterniond(Eigen::AngleAxisd(angle, axis.normalized()))};
}

DesignVariable variableOf(const std::string& name, const DesignTarget& target) {
  DesignVariable variable;
  variable.name = name;
  variable.target = target;
  return variable;
}

/// A holder on a table, both turned and away from the origin; a lamp by itself.
Scene workshop() {
  Scene scene;
  scene.components.resize(3);
  scene.components[0].name = "table";
  scene.components[0].pose = poseOf({1.0, 2.0, 0.5}, 0.7, {1, 2, 3});
  scene.components[1].name = "holder";
  scene.components[1].parent = "table";
  scene.components[1].pose = poseOf({0.1, 0.0, 0.3}, -1.1, {0, 1, 1});
  scene.components[1].visuals.resize(1);
  scene.components[1].visuals[0].pose.position = {0.0, 0.0, 0.2};
  scene.components[1].visuals[0].mesh_resource = "package://some/mesh.stl";
  scene.components[2].name = "lamp";
  scene.design_variables = {variableOf("table_x", ComponentTranslation{0, Axis::x}),
                            variableOf("holder_z", ComponentTranslation{1, Axis::z}),
                            variableOf("holder_ry", ComponentRotation{1, Axis::y})};
  return scene;
}

TEST(ComponentDeviations, NothingDeviatesAtTheDesign) {
  EXPECT_TRUE(componentDeviations(workshop(), {}, {}, {}).empty());
  EXPECT_TRUE(componentDeviations(workshop(), {{"table_x", 0.0}, {"holder_ry", 0.0}}, {}, {}).empty());
}

TEST(ComponentDeviations, AreInTheComponentsOwnFrameWhereverThatIs) {
  const ComponentPoses moved = {{"table", poseOf({-3.0, 0.2, 0.1}, 2.0, {0, 0, 1})}};
  for (const ComponentPoses& where : {ComponentPoses(), moved}) {
    const ComponentPoses found =
        componentDeviations(workshop(), {{"holder_z", 0.002}, {"holder_ry", 0.1}}, where, where);
    ASSERT_EQ(found.size(), 1u);
    EXPECT_LT((found.at("holder").position - Eigen::Vector3d(0.0, 0.0, 0.002)).norm(), 1e-12);
    const Eigen::Quaterniond turn(Eigen::AngleAxisd(0.1, Eigen::Vector3d::UnitY()));
    EXPECT_LT(found.at("holder").orientation.angularDistance(turn), 1e-12);
  }
}

TEST(ComponentDeviations, WhatRidesOnAComponentDeviatesWithIt) {
  const Scene scene = workshop();
  const ComponentPoses found = componentDeviations(scene, {{"table_x", 0.003}}, {}, {});
  ASSERT_EQ(found.size(), 2u);
  EXPECT_LT((found.at("table").position - Eigen::Vector3d(0.003, 0.0, 0.0)).norm(), 1e-12);
  const Eigen::Vector3d shift =
      scene.components[1].pose.orientation.conjugate() * Eigen::Vector3d(0.003, 0.0, 0.0);
  EXPECT_LT((found.at("holder").position - shift).norm(), 1e-12);
}

TEST(ComponentDeviations, ComeThroughAMessage) {
  const ComponentPoses sent = {{"holder", poseOf({0.1, 0.2, 0.3}, 0.4, {1, 0, 2})}};
  const ComponentPoses back = fromMessage(toMessage(sent));
  ASSERT_EQ(back.size(), 1u);
  EXPECT_EQ(back.at("holder").position, sent.at("holder").position);
  EXPECT_LT(back.at("holder").orientation.angularDistance(sent.at("holder").orientation), 1e-12);

  cable_variation::ComponentDeviations broken = toMessage(sent);
  broken.components[0].pose.position.x = std::nan("");
  try {
    fromMessage(broken);
    ADD_FAILURE() << "no error";
  } catch (const std::invalid_argument& error) {
    EXPECT_NE(std::string(error.what()).find("'holder'"), std::string::npos) << error.what();
  }
}

TEST(ComponentDeviations, MoveTheMeshInItsFrame) {
  const Pose quarter = poseOf({0.01, 0.0, 0.0}, M_PI_2, Eigen::Vector3d::UnitX());
  const visualization_msgs::MarkerArray array =
      componentMarkers(workshop(), {"holder"}, {{"holder", quarter}});
  ASSERT_EQ(array.markers.size(), 1u);
  EXPECT_EQ(array.markers[0].header.frame_id, "holder");
  // 0.2 m along z, which the quarter turn about x takes to -y.
  EXPECT_NEAR(array.markers[0].pose.position.x, 0.01, 1e-12);
  EXPECT_NEAR(array.markers[0].pose.position.y, -0.2, 1e-12);
  EXPECT_NEAR(array.markers[0].pose.position.z, 0.0, 1e-12);
}

}  // namespace
}  // namespace cable_variation_ros
