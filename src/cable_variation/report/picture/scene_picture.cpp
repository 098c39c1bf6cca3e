#include <cable_variation/report/picture/scene_picture.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include <cable_variation/report/picture/picture_layers.h>
#include <cable_variation/report/picture/png.h>
#include <cable_variation/report/picture/tube_mesh.h>

namespace cable_variation {

using Eigen::Vector3d;

namespace {

constexpr double kWidth = 1200.0, kHeight = 720.0;  // [px]
constexpr double kFiner = 2.0;                      // drawn so much finer, then averaged: smooth edges
constexpr double kTrial = 0.15;                     // size of the pictures that choose the view
constexpr double kMargin = 0.1, kLeast = 0.02;      // around the cables; [m] across
constexpr std::size_t kMostTrials = 40, kFewestTrials = 6;
constexpr std::size_t kMostTrialTriangles = 3'000'000;

/// Parts and cables in the world.
struct Things {
  std::vector<Surface> parts, cables, envelope;
  Eigen::Matrix3Xd extent;  // points around the cables
};

std::vector<Surface> partsOf(const Scene& scene, const ComponentPoses& poses) {
  std::vector<Surface> parts;
  for (const Component& component : scene.components) {
    const Pose& pose = poses.at(component.name);
    for (const Visual& visual : component.visuals) {
      if (!visual.mesh) continue;
      Surface part;
      const Pose at = pose * visual.pose;
      for (const Vector3d& vertex : visual.mesh->vertices) part.vertices.push_back(at * vertex);
      part.triangles = visual.mesh->triangles;
      for (int k = 0; k < 3; ++k) {
        part.colour[static_cast<std::size_t>(k)] =
            static_cast<std::uint8_t>(std::lround(255.0 * std::clamp(visual.color[k], 0.0, 1.0)));
      }
      parts.push_back(std::move(part));
    }
  }
  return parts;
}

Things thingsOf(const Scene& scene, const SolvedScene& solved,
                const std::vector<const TriangleMesh*>& envelope) {
  constexpr double kStep = 1e-3;  // [m]
  Things things;
  things.parts = partsOf(scene, solved.components);
  std::vector<Vector3d> extent;
  for (std::size_t i = 0; i < solved.harness.cables.size(); ++i) {
    TubeMesh tube = tubeMesh(solved.harness.cables[i], solved.equilibrium.shapes[i], kStep);
    extent.insert(extent.end(), tube.mesh.vertices.begin(), tube.mesh.vertices.end());
    things.cables.push_back({std::move(tube.mesh.vertices), std::move(tube.mesh.triangles),
                             std::move(tube.normals), cablePaint(i)});
  }
  for (const TriangleMesh* mesh : envelope) {
    things.envelope.push_back({mesh->vertices, mesh->triangles, {}, {90, 130, 200}});
    extent.insert(extent.end(), mesh->vertices.begin(), mesh->vertices.end());
  }
  things.extent.resize(3, static_cast<Eigen::Index>(extent.size()));
  for (std::size_t i = 0; i < extent.size(); ++i) things.extent.col(static_cast<Eigen::Index>(i)) = extent[i];
  return things;
}

Camera cameraFrom(const Vector3d& direction, const Vector3d& up, double finer, const Things& things) {
  Camera camera;
  camera.axes = cameraAxes(direction, up);
  camera.width = std::round(finer * kWidth);
  camera.height = std::round(finer * kHeight);
  frame(camera, things.extent, kMargin, kLeast);
  return camera;
}

/// How much of the cables is seen [m²].
double seen(const Things& things, const Camera& camera) {
  Raster parts = rasterFor(camera), cables = rasterFor(camera);
  for (const Surface& part : things.parts) part.draw(camera, parts);
  for (const Surface& cable : things.cables) cable.draw(camera, cables);
  std::size_t pixels = 0;
  for (std::size_t y = 0; y < cables.height(); ++y) {
    for (std::size_t x = 0; x < cables.width(); ++x) {
      const float depth = cables.depth(x, y);
      if (depth > Raster::kNothing && depth > parts.depth(x, y)) ++pixels;
    }
  }
  return static_cast<double>(pixels) / (camera.pixels_per_metre * camera.pixels_per_metre);
}

/// Directions to look from, the usual ones first: round about, slantwise from above.
std::vector<Vector3d> directions(const Vector3d& up, std::size_t count) {
  constexpr double kGoldenAngle = 2.39996;     // [rad]: any number of them is spread evenly
  constexpr double kLow = 0.26, kHigh = 0.87;  // sines of 15° and 60°
  const Vector3d front = up.unitOrthogonal(), side = up.cross(front);
  std::vector<Vector3d> all;
  for (std::size_t i = 0; i < count; ++i) {
    const double turn = kGoldenAngle * static_cast<double>(i) + 0.6;
    const double height = kLow + (kHigh - kLow) * (0.5 + static_cast<double>(i)) / static_cast<double>(count);
    const double across = std::sqrt(1.0 - height * height);
    all.push_back(across * (std::cos(turn) * front + std::sin(turn) * side) + height * up);
  }
  return all;
}

}  // namespace

Colour cablePaint(std::size_t cable) {
  constexpr std::array<Colour, 6> kPaints = {
      {{0, 114, 178}, {230, 159, 0}, {0, 158, 115}, {204, 121, 167}, {86, 180, 233}, {213, 94, 0}}};
  return kPaints[cable % kPaints.size()];
}

ScenePicture scenePicture(const Scene& scene, const SolvedScene& solved,
                          const std::vector<const TriangleMesh*>& envelope) {
  if (solved.harness.cables.empty()) throw std::invalid_argument("a scene without cables has no picture");
  const Things things = thingsOf(scene, solved, envelope);
  const Vector3d& gravity = solved.harness.gravity;
  const Vector3d up = gravity.norm() > 0.0 ? Vector3d(-gravity.normalized()) : Vector3d::UnitZ();

  std::size_t triangles = 1;
  for (const Surface& part : things.parts) triangles += part.triangles.size();
  const std::size_t trials = std::clamp(kMostTrialTriangles / triangles, kFewestTrials, kMostTrials);
  Vector3d best = up;
  double most = -1.0;
  for (const Vector3d& direction : directions(up, trials)) {
    const double area = seen(things, cameraFrom(direction, up, kTrial, things));
    if (area <= most) continue;
    most = area;
    best = direction;
  }

  const Camera fine = cameraFrom(best, up, kFiner, things);
  PictureLayers layers{rasterFor(fine), rasterFor(fine), rasterFor(fine)};
  for (const Surface& part : things.parts) part.draw(fine, layers.parts);
  for (const Surface& cable : things.cables) cable.draw(fine, layers.cables);
  for (const Surface& body : things.envelope) body.draw(fine, layers.envelope);
  ScenePicture picture;
  picture.camera = cameraFrom(best, up, 1.0, things);
  picture.png = png(composed(layers, static_cast<std::size_t>(kFiner)));
  return picture;
}

}  // namespace cable_variation
