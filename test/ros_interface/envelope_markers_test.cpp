// Envelopes seen: one translucent colour per cable, lit.
#include <ros_interface/markers/envelope_markers.h>

#include <gtest/gtest.h>

namespace cable_variation_ros {
namespace {

using namespace cable_variation;
using visualization_msgs::Marker;

Scene twoCables() {
  Scene scene;
  scene.harness.cables.resize(2);
  scene.harness.cables[0].name = "main";
  scene.harness.cables[1].name = "branch";
  return scene;
}

TriangleMesh tetrahedron() {
  TriangleMesh mesh;
  mesh.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  mesh.triangles = {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}};
  return mesh;
}

TEST(EnvelopeMarkers, OneListPerCableInItsColourWithoutColoursOfItsOwnWhichWouldNotBeLit) {
  const auto array = envelopeMarkers(twoCables(), {{0, tetrahedron()}, {1, tetrahedron()}});
  ASSERT_EQ(array.markers.size(), 2u);
  EXPECT_EQ(array.markers[0].ns, "envelope/main");
  EXPECT_EQ(array.markers[1].ns, "envelope/branch");
  for (const Marker& marker : array.markers) {
    EXPECT_EQ(marker.type, Marker::TRIANGLE_LIST);
    EXPECT_EQ(marker.points.size(), 12u);
    EXPECT_TRUE(marker.colors.empty());
    EXPECT_EQ(marker.header.frame_id, "world");
    EXPECT_GT(marker.color.a, 0.1f);
    EXPECT_LT(marker.color.a, 0.6f);
  }
  EXPECT_NE(array.markers[0].color, array.markers[1].color);
}

TEST(EnvelopeMarkers, PiecesShowEveryEdgeOnce) {
  EnvelopePiece piece{1, 0.0, 0.01, 0, 0, {ConvexHull(tetrahedron().vertices), 0.004}, {}};
  const auto array = pieceMarkers(twoCables(), {piece, piece});
  ASSERT_EQ(array.markers.size(), 1u);
  EXPECT_EQ(array.markers[0].ns, "envelope/branch/pieces");
  EXPECT_EQ(array.markers[0].points.size(), 2u * 2u * 6u);  // two pieces of six edges of two ends
}

}  // namespace
}  // namespace cable_variation_ros
