// Pictures of scenes: what is drawn where, and that the file is a PNG that others read.
#include <cable_variation/report/picture/scene_picture.h>

#include <cmath>

#include <gtest/gtest.h>
#include <png.h>

#include <cable_variation/report/picture/picture_layers.h>
#include <cable_variation/report/picture/tube_mesh.h>
#include <measures/solved_scene.h>

namespace cable_variation {
namespace {

using Eigen::Vector3d;

Pixels decoded(const std::string& file) {
  png_image image{};
  image.version = PNG_IMAGE_VERSION;
  Pixels pixels;
  if (png_image_begin_read_from_memory(&image, file.data(), file.size()) == 0) return pixels;
  image.format = PNG_FORMAT_RGBA;
  pixels.width = image.width;
  pixels.height = image.height;
  pixels.rgba.resize(PNG_IMAGE_SIZE(image));
  if (png_image_finish_read(&image, nullptr, pixels.rgba.data(), 0, nullptr) == 0) return {};
  return pixels;
}

std::array<int, 4> at(const Pixels& pixels, double x, double y) {
  const std::size_t first = 4 * (static_cast<std::size_t>(y) * pixels.width + static_cast<std::size_t>(x));
  return {pixels.rgba.at(first), pixels.rgba.at(first + 1), pixels.rgba.at(first + 2),
          pixels.rgba.at(first + 3)};
}

TEST(Png, IsReadBackByteForByte) {
  Pixels pixels{3, 2, {}};
  for (int i = 0; i < 24; ++i) pixels.rgba.push_back(static_cast<std::uint8_t>(10 * i));
  for (std::size_t i = 3; i < 24; i += 4) pixels.rgba[i] = 255;
  const Pixels back = decoded(png(pixels));
  EXPECT_EQ(back.width, 3u);
  EXPECT_EQ(back.height, 2u);
  EXPECT_EQ(back.rgba, pixels.rgba);
  pixels.rgba.pop_back();
  EXPECT_THROW(png(pixels), std::invalid_argument);
  EXPECT_THROW(png(Pixels()), std::invalid_argument);
}

TEST(Camera, LooksAtThePointsUpright) {
  Camera camera;
  camera.width = 400.0;
  camera.height = 200.0;
  camera.axes = cameraAxes(-Vector3d::UnitY(), Vector3d::UnitZ());  // from the front
  Eigen::Matrix3Xd points(3, 2);
  points << 1.0, 3.0, 5.0, 7.0, 2.0, 2.5;
  frame(camera, points, 0.1, 0.01);
  // 2 m across take 0.8 of 400 px
  EXPECT_NEAR(camera.pixels_per_metre, 160.0, 1e-9);
  EXPECT_NEAR((camera.project({1.0, 6.0, 2.25}) - Vector3d(40.0, 100.0, 0.0)).norm(), 0.0, 1e-9);
  EXPECT_NEAR((camera.project({3.0, 5.0, 2.5}) - Vector3d(360.0, 60.0, 1.0)).norm(), 0.0, 1e-9);
  const Eigen::Matrix3d above = cameraAxes(Vector3d::UnitZ(), Vector3d::UnitZ());
  EXPECT_NEAR((above * above.transpose() - Eigen::Matrix3d::Identity()).norm(), 0.0, 1e-12);
  EXPECT_NEAR(above.determinant(), 1.0, 1e-12);
}

std::array<Corner, 3> triangle(double depth) {
  return {{{{10.0, 10.0, depth}, 1.0}, {{90.0, 10.0, depth}, 1.0}, {{10.0, 60.0, depth}, 1.0}}};
}

TEST(Raster, CoversTheAreaOfATriangle) {
  Raster raster(100, 80);
  raster.draw(triangle(0.0), {255, 0, 0});
  std::size_t count = 0;
  for (std::size_t y = 0; y < 80; ++y) {
    for (std::size_t x = 0; x < 100; ++x) count += raster.depth(x, y) > Raster::kNothing ? 1 : 0;
  }
  EXPECT_NEAR(static_cast<double>(count), 0.5 * 80.0 * 50.0, 80.0);  // half a pixel along its edges
  EXPECT_GT(raster.depth(12, 12), Raster::kNothing);
  EXPECT_EQ(raster.depth(80, 55), Raster::kNothing);
}

TEST(Raster, TheNearestCountsInAnyOrder) {
  for (const bool near_first : {true, false}) {
    Raster raster(100, 80);
    raster.draw(triangle(near_first ? 2.0 : 1.0), near_first ? Colour{255, 0, 0} : Colour{0, 255, 0});
    raster.draw(triangle(near_first ? 1.0 : 2.0), near_first ? Colour{0, 255, 0} : Colour{255, 0, 0});
    EXPECT_EQ(raster.colour(20, 20), (Colour{255, 0, 0}));
    EXPECT_EQ(raster.depth(20, 20), 2.0F);
  }
}

TEST(Raster, WhatCannotBeDrawnLeavesNothing) {
  Raster raster(20, 20);
  std::array<Corner, 3> wrong = triangle(0.0);
  wrong[1].place.x() = std::nan("");
  raster.draw(wrong, {1, 2, 3});
  wrong = triangle(0.0);
  wrong[1] = wrong[2];
  raster.draw(wrong, {1, 2, 3});
  wrong = triangle(0.0);
  for (Corner& corner : wrong) corner.place.x() -= 1e6;
  raster.draw(wrong, {1, 2, 3});
  for (std::size_t i = 0; i < 400; ++i) EXPECT_EQ(raster.depth(i % 20, i / 20), Raster::kNothing);
}

/// A cable along x, a quarter of it under a plate.
class Picture : public testing::Test {
 protected:
  Picture() {
    Harness harness;
    harness.gravity.setZero();
    harness.cables = {test::uniformCable(0.4, test::roundSection(1e3, 4e2, 1e-2, 1e-2, 0.0, 0.01))};
    harness.clips = {test::clipOn(0, "start", 0.0, fixedClip())};
    scene_ = test::sceneOf(harness);
    scene_.components = {
        test::boxPart("plate", {0.1, 0.3, 0.004}, {{0.35, 0.0, 0.1}, Eigen::Quaterniond::Identity()})};
    EquilibriumSolver solver;
    solved_ = test::solveAt(scene_, {}, solver);
  }

  std::array<int, 4> seenAt(const ScenePicture& picture, const Vector3d& place) const {
    const Vector3d pixel = picture.camera.project(place);
    return at(decoded(picture.png), pixel.x(), pixel.y());
  }

  Scene scene_;
  test::Solved solved_;
};

TEST_F(Picture, ShowsTheCableInItsColourWhereNothingHidesIt) {
  ASSERT_TRUE(solved_.equilibrium.converged()) << solved_.equilibrium.message;
  const ScenePicture picture = scenePicture(scene_, solved_.view());
  const Pixels pixels = decoded(picture.png);
  EXPECT_EQ(pixels.width, static_cast<std::size_t>(picture.camera.width));
  EXPECT_EQ(pixels.height, static_cast<std::size_t>(picture.camera.height));
  const Colour paint = cablePaint(0);
  const auto seen = seenAt(picture, {0.1, 0.0, 0.0});
  EXPECT_EQ(seen[3], 255);
  for (std::size_t a = 0; a < 3; ++a) {  // lit, in the same hue
    for (std::size_t b = 0; b < a; ++b) EXPECT_NEAR(seen[a] * paint[b], seen[b] * paint[a], 600) << a << b;
  }
  std::size_t clear = 0;  // nothing is there: the page's own colour
  for (std::size_t i = 3; i < pixels.rgba.size(); i += 4) clear += pixels.rgba[i] == 0 ? 1 : 0;
  EXPECT_GT(clear, pixels.rgba.size() / 4 / 10);
}

TEST_F(Picture, ACableBehindAPartShinesThrough) {
  scene_.components = {
      test::boxPart("cage", {0.8, 0.2, 0.2}, {{0.2, 0.0, 0.0}, Eigen::Quaterniond::Identity()})};
  scene_.components[0].visuals[0].color = {1.0, 1.0, 1.0, 1.0};
  solved_.components = componentPosesAt(scene_, {});
  const ScenePicture picture = scenePicture(scene_, solved_.view());
  const auto beside = seenAt(picture, {0.1, 0.0, 0.05}), behind = seenAt(picture, {0.1, 0.0, 0.0});
  EXPECT_EQ(behind[3], 255);
  EXPECT_NEAR(beside[0], beside[2], 2);         // white, lit
  EXPECT_GT(behind[2] - behind[0], 30);         // tinted blue
  EXPECT_GT(behind[0], cablePaint(0)[0] + 50);  // but not the cable's own colour
}

TEST_F(Picture, ChoosesAViewFromWhichTheCableIsSeen) {
  // A wall along the cable on each of three sides: only from the fourth it is seen.
  const auto wall = [](const std::string& name, const Vector3d& position) {
    return test::boxPart(name, {0.6, 0.005, 0.5}, {position, Eigen::Quaterniond::Identity()});
  };
  scene_.components = {wall("front", {0.2, -0.08, 0.1})};
  solved_.components = componentPosesAt(scene_, {});
  const ScenePicture picture = scenePicture(scene_, solved_.view());
  EXPECT_GT(picture.camera.axes(2, 1), 0.0);  // from behind
  const auto seen = seenAt(picture, {0.2, 0.0, 0.0});
  EXPECT_GT(seen[2], seen[0] + 60);
}

TEST_F(Picture, AnEnvelopeIsTranslucent) {
  TriangleMesh around = boxMesh({0.5, 0.06, 0.06});
  for (Vector3d& vertex : around.vertices) vertex.x() += 0.2;
  const ScenePicture picture = scenePicture(scene_, solved_.view(), {&around});
  const Vector3d place(0.1, 0.0, 0.022);
  const auto with = seenAt(picture, place);
  EXPECT_GT(with[3], 60);
  EXPECT_LT(with[3], 130);
  EXPECT_GT(with[2], with[0]);
}

TEST_F(Picture, OfNoCableIsRefused) {
  scene_.harness.cables.clear();
  const Harness none;
  EXPECT_THROW(scenePicture(scene_, {none, solved_.equilibrium, solved_.components}), std::invalid_argument);
}

TEST_F(Picture, TubesAreClosedAndOfTheirRadius) {
  const TubeMesh tube = tubeMesh(solved_.harness.cables[0], solved_.equilibrium.shapes[0], 0.01);
  ASSERT_EQ(tube.mesh.vertices.size(), tube.normals.size());
  double volume = 0.0;
  for (const auto& [a, b, c] : tube.mesh.triangles) {
    const auto& v = tube.mesh.vertices;
    volume += v[a].dot(v[b].cross(v[c])) / 6.0;
  }
  EXPECT_NEAR(volume, M_PI * 1e-4 * 0.4, 0.02 * M_PI * 1e-4 * 0.4);  // a polygon of 20 sides: 1.6 % less
  for (std::size_t i = 0; i < tube.normals.size(); ++i) EXPECT_NEAR(tube.normals[i].norm(), 1.0, 1e-9);
}

}  // namespace
}  // namespace cable_variation
