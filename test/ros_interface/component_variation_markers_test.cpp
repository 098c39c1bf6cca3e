// Parts coloured by their six sigma: hues as on the legend, one scale for all, in the parts' frames.
#include <ros_interface/markers/component_variation_markers.h>

#include <memory>

#include <gtest/gtest.h>

#include <ros_interface/markers/colour_map.h>

namespace cable_variation_ros {
namespace {

using namespace cable_variation;
using Eigen::Vector3d;
using visualization_msgs::Marker;

/// A part of one tetrahedron whose origin varies along z by `sigma` and which turns about y by `turn_sigma`.
class ComponentVariationMarkers : public testing::Test {
 protected:
  ComponentVariationMarkers() {
    TriangleMesh mesh;
    mesh.vertices = {{0.0, 0.0, 0.0}, {0.1, 0.0, 0.0}, {0.0, 0.1, 0.0}, {0.0, 0.0, 0.1}};
    mesh.triangles = {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}};
    for (const char* name : {"calm", "loose"}) {
      Component part;
      part.name = name;
      part.pose.position = {1.0, 0.0, 0.0};
      Visual visual;
      visual.mesh = std::make_shared<const TriangleMesh>(mesh);
      part.visuals = {visual};
      scene_.components.push_back(part);
    }
    variations_.resize(2);
    for (std::size_t i = 0; i < 2; ++i) {
      variations_[i].component = i;
      variations_[i].origin = {1.0, 0.0, 0.0};
      const double sigma = i == 0 ? 1e-4 : 4e-4;  // [m]
      variations_[i].covariance(2, 2) = sigma * sigma;
    }
    poses_ = componentPosesAt(scene_, {});
  }

  Scene scene_;
  std::vector<ComponentVariation> variations_;
  ComponentPoses poses_;
};

TEST_F(ComponentVariationMarkers, HaveTheLegendsHueOnOneScale) {
  const ComponentVariationView view = componentVariationMarkers(scene_, variations_, poses_);
  EXPECT_DOUBLE_EQ(view.legend.minimum, 0.0);
  EXPECT_NEAR(view.legend.maximum, 2.4, 1e-9);  // six times 0.4 mm
  EXPECT_EQ(view.legend.unit, "mm");
  EXPECT_EQ(view.legend.note, "");
  ASSERT_EQ(view.markers.markers.size(), 4u);
  for (std::size_t part = 0; part < 2; ++part) {
    const Marker& mesh = view.markers.markers[2 * part];
    EXPECT_EQ(mesh.ns, part == 0 ? "variation/calm" : "variation/loose");
    EXPECT_EQ(mesh.header.frame_id, part == 0 ? "calm" : "loose");
    EXPECT_TRUE(mesh.frame_locked);
    ASSERT_EQ(mesh.points.size(), 12u);
    ASSERT_EQ(mesh.colors.size(), 12u);
    const Vector3d expected = viridis(part == 0 ? 0.25 : 1.0);
    for (const std_msgs::ColorRGBA& color : mesh.colors) {
      const Vector3d found(color.r, color.g, color.b);
      // The light scales all of r g b alike.
      EXPECT_LT((found.normalized() - expected.normalized()).norm(), 1e-6);
      const double brightness = found.norm() / expected.norm();
      EXPECT_GE(brightness, 0.65);
      EXPECT_LE(brightness, 1.0 + 1e-6);
    }
  }
  EXPECT_EQ(view.markers.markers[3].type, Marker::TEXT_VIEW_FACING);
  EXPECT_EQ(view.markers.markers[3].text, "loose: up to 2.40 mm");
  EXPECT_EQ(view.markers.markers[1].text, "calm: up to 0.60 mm");
}

TEST_F(ComponentVariationMarkers, LieJustOutsideTheMeshWhereTheDesignHasIt) {
  Pose deviation;
  deviation.position = {0.0, 0.0, 0.02};
  poses_["calm"] = poses_["calm"] * deviation;
  const ComponentVariationView view =
      componentVariationMarkers(scene_, variations_, poses_, {{"calm", deviation}});
  const Marker& mesh = view.markers.markers[0];
  EXPECT_EQ(mesh.pose.position.z, 0.02);
  const TriangleMesh& shape = *scene_.components[0].visuals[0].mesh;
  for (std::size_t i = 0; i < mesh.points.size(); ++i) {
    const Vector3d point(mesh.points[i].x, mesh.points[i].y, mesh.points[i].z);
    const Vector3d offset = point - shape.vertices[shape.triangles[i / 3][i % 3]];
    EXPECT_NEAR(offset.norm(), 1e-4, 1e-12);
    EXPECT_GT(offset.dot(point - Vector3d::Constant(0.025)), 0.0);  // away from the middle
  }
}

TEST_F(ComponentVariationMarkers, SayWhereMeansAreOffTheDesign) {
  variations_[1].mean[0] = 2.5e-4;
  const ComponentVariationView view = componentVariationMarkers(scene_, variations_, poses_);
  EXPECT_NE(view.legend.note.find("0.25 mm"), std::string::npos) << view.legend.note;
}

TEST_F(ComponentVariationMarkers, OfNothingAreNone) {
  const ComponentVariationView view = componentVariationMarkers(scene_, {}, poses_);
  EXPECT_TRUE(view.markers.markers.empty());
  EXPECT_EQ(view.legend.title, "");
}

}  // namespace
}  // namespace cable_variation_ros
