#include <cable_variation/scene_file/urdf_reader.h>

#include <algorithm>
#include <map>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include <cable_variation/geometry/mesh/mesh_reader.h>
#include <cable_variation/scene/resource_address.h>

#include "test_packages.h"

namespace cable_variation {
namespace {

using Eigen::Vector3d;

LoadedMesh load(const std::string& address, const Vector3d& scale) {
  const ResourceFile file = findResource(address, findTestPackage);
  return {std::make_shared<TriangleMesh>(readMesh(file.path, scale)), file.url};
}

std::vector<Visual> readArm(const std::map<std::string, JointPosition>& positions) {
  std::vector<std::string> faults, warnings;
  const auto visuals =
      readUrdf(findTestPackage("test_data") + "/urdf/arm.urdf", positions, load, faults, warnings);
  EXPECT_EQ(faults, std::vector<std::string>());
  EXPECT_EQ(warnings, std::vector<std::string>());
  return visuals;
}

const Visual& named(const std::vector<Visual>& visuals, const std::string& name) {
  for (const Visual& visual : visuals) {
    if (visual.name == name) return visual;
  }
  throw std::out_of_range(name);
}

void expectNear(const Vector3d& a, const Vector3d& b) {
  EXPECT_NEAR((a - b).norm(), 0.0, 1e-9) << a.transpose() << " and " << b.transpose();
}

TEST(Urdf, takesVisualsAndElseCollisions) {
  const auto visuals = readArm({});
  ASSERT_EQ(visuals.size(), 5U);
  EXPECT_EQ(visuals[0].name, "base");
  EXPECT_EQ(visuals[0].mesh->triangles.size(), 12U);  // a box, not the collision's sphere
  EXPECT_EQ(visuals[0].mesh_resource, "");
  EXPECT_NEAR((visuals[0].color - Eigen::Vector4d(0.8, 0.1, 0.1, 1.0)).norm(), 0.0, 1e-6);
  EXPECT_NO_THROW(named(visuals, "upper"));  // has a collision geometry only
}

TEST(Urdf, placesAndScalesMeshes) {
  const auto visuals = readArm({});
  const Visual& mesh = visuals[1];
  EXPECT_EQ(mesh.mesh_resource, "package://test_data/meshes/tetrahedron.stl");
  expectNear(mesh.mesh_scale, {0.1, 0.1, 0.1});
  expectNear(mesh.pose.position, {0.0, 0.0, 0.5});
  expectNear(mesh.pose * Vector3d::UnitX(), {0.0, 1.0, 0.5});
  double largest = 0.0;
  for (const Vector3d& vertex : mesh.mesh->vertices) largest = std::max(largest, vertex.maxCoeff());
  EXPECT_NEAR(largest, 0.1, 1e-9);
}

TEST(Urdf, jointsAtZero) {
  const auto visuals = readArm({});
  expectNear(named(visuals, "upper").pose.position, {0.0, 0.0, 1.0});
  expectNear(named(visuals, "finger").pose.position, {0.3, 0.0, 1.0});
  expectNear(named(visuals, "thumb").pose.position, {0.3, 0.0, 1.001});  // the mimic's offset
}

TEST(Urdf, jointsAtGivenPositions) {
  constexpr double kQuarter = 1.5707963267948966;
  const auto visuals = readArm(
      {{"shoulder", {kQuarter, JointPosition::Unit::radian}}, {"grip", {0.02, JointPosition::Unit::metre}}});
  // a quarter turn about y takes x to -z and z to x
  expectNear(named(visuals, "upper").pose * Vector3d::UnitX(), {0.0, 0.0, 0.0});
  expectNear(named(visuals, "finger").pose.position, {0.02, 0.0, 0.7});
  expectNear(named(visuals, "thumb").pose.position, {-0.039, 0.0, 0.7});
}

TEST(Urdf, linksAreWhereTheirJointsPutThem) {
  constexpr double kTurn = 0.7, kGrip = 0.03;
  const auto readLinks = [](const std::map<std::string, JointPosition>& positions) {
    std::vector<std::string> faults, warnings;
    return readUrdfLinks(findTestPackage("test_data") + "/urdf/arm.urdf", positions, load, faults, warnings);
  };
  const auto links = readLinks({});
  const auto posed = readLinks(
      {{"shoulder", {kTurn, JointPosition::Unit::radian}}, {"grip", {kGrip, JointPosition::Unit::metre}}});
  ASSERT_EQ(links.size(), 5U);
  EXPECT_EQ(links[0].name, "base");
  EXPECT_FALSE(links[0].joint);
  std::map<std::string, Pose> poses{{"base", Pose()}};
  const std::map<std::string, double> positions{{"shoulder", kTurn}, {"grip", kGrip}, {"", 0.0}};
  for (std::size_t i = 1; i < links.size(); ++i) {
    ASSERT_TRUE(links[i].joint);
    // the links that were read with the joints at 0, moved, are those that were read with them moved
    const Pose pose =
        poses.at(links[i].parent) * linkPose(*links[i].joint, positions.at(links[i].joint->driver));
    poses[links[i].name] = pose;
    expectNear(pose.position, posed[i].pose.position);
    EXPECT_NEAR(pose.orientation.angularDistance(posed[i].pose.orientation), 0.0, 1e-7);
  }
  const auto named = [&](const std::string& name) -> const UrdfLink& {
    return *std::find_if(links.begin(), links.end(), [&](const UrdfLink& link) { return link.name == name; });
  };
  const LinkJoint& thumb = *named("thumb").joint;
  EXPECT_EQ(thumb.name, "counter_grip");
  EXPECT_EQ(thumb.driver, "grip");
  EXPECT_DOUBLE_EQ(thumb.multiplier, -2.0);
  EXPECT_DOUBLE_EQ(thumb.offset, 0.001);
  EXPECT_DOUBLE_EQ(thumb.lower, -0.2);
  EXPECT_EQ(named("frame_only").joint->type, LinkJoint::Type::fixed);
  EXPECT_EQ(named("finger").joint->type, LinkJoint::Type::prismatic);
  expectNear(named("finger").joint->axis, Vector3d::UnitZ());
}

TEST(Urdf, parserMessagesAreFaultsAndNotPrinted) {
  std::vector<std::string> faults, warnings;
  testing::internal::CaptureStderr();
  const TemporaryFile file(
      "shapeless.urdf", {"<robot name=\"x\"><link name=\"a\"><visual><geometry/></visual></link></robot>"});
  readUrdf(file.path(), {}, load, faults, warnings);
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
  ASSERT_EQ(faults.size(), 1U);
  EXPECT_NE(faults[0].find("Geometry tag contains no child element"), std::string::npos) << faults[0];
}

TEST(Urdf, aFileThatIsNoXml) {
  std::vector<std::string> faults, warnings;
  readUrdf(findTestPackage("test_data") + "/samples.txt", {}, load, faults, warnings);
  EXPECT_EQ(faults.size(), 1U);
}

}  // namespace
}  // namespace cable_variation
