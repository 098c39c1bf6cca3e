#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>
#include <string>
#include <vector>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <cable_variation/equilibrium/equilibrium.h>
#include <cable_variation/geometry/mesh/triangle_mesh.h>
#include <cable_variation/scene_file/scene_reader.h>

namespace cable_variation {
namespace {

using Eigen::Vector3d;

const std::string kRoot = CABLE_VARIATION_SOURCE_DIR;

std::vector<std::string> sceneFiles() {
  std::vector<std::string> files;
  for (const auto& entry : std::filesystem::directory_iterator(kRoot + "/config")) {
    if (entry.path().extension() == ".yaml") files.push_back(entry.path().string());
  }
  std::sort(files.begin(), files.end());
  return files;
}

double distanceToSegment(const Vector3d& p, const Vector3d& a, const Vector3d& b) {
  const double t = (p - a).dot(b - a) / (b - a).squaredNorm();
  return (p - a - std::clamp(t, 0.0, 1.0) * (b - a)).norm();
}

double distanceToTriangle(const Vector3d& p, const Vector3d& a, const Vector3d& b, const Vector3d& c) {
  const Vector3d normal = (b - a).cross(c - a).normalized();
  const bool over = (b - a).cross(p - a).dot(normal) >= 0.0 && (c - b).cross(p - b).dot(normal) >= 0.0 &&
                    (a - c).cross(p - c).dot(normal) >= 0.0;
  if (over) return std::abs((p - a).dot(normal));
  return std::min({distanceToSegment(p, a, b), distanceToSegment(p, b, c), distanceToSegment(p, c, a)});
}

// By brute force over every triangle that could be nearer than `bound` [m], the value if none is.
double distanceToComponent(const Scene& scene, const Component& component, const Vector3d& point,
                           double bound) {
  const Pose in_world = componentPose(scene, component.name);
  double nearest = bound;
  for (const Visual& visual : component.visuals) {
    const Vector3d p = (in_world * visual.pose).inverse() * point;
    const std::vector<Vector3d>& v = visual.mesh->vertices;
    for (const auto& t : visual.mesh->triangles) {
      const Vector3d &a = v[t[0]], &b = v[t[1]], &c = v[t[2]];
      const Vector3d low = a.cwiseMin(b).cwiseMin(c), high = a.cwiseMax(b).cwiseMax(c);
      if (((low - p).array() > nearest).any() || ((p - high).array() > nearest).any()) continue;
      nearest = std::min(nearest, distanceToTriangle(p, a, b, c));
    }
  }
  return nearest;
}

Scene readShipped(const std::string& file) {
  return readScene(file, [](const std::string&) { return kRoot; });
}

const Component& componentNamed(const Scene& scene, const std::string& name) {
  return *std::find_if(scene.components.begin(), scene.components.end(),
                       [&](const Component& component) { return component.name == name; });
}

TEST(Clearance, EveryClipSitsOnItsComponent) {
  for (const std::string& file : sceneFiles()) {
    const Scene scene = readShipped(file);
    for (std::size_t i = 0; i < scene.harness.clips.size(); ++i) {
      const Clip& clip = scene.harness.clips[i];
      const Component& component = componentNamed(scene, scene.clip_mounts[i].component);
      // A tab under a ring or tube clip is two to three radii below it, a connector touches it.
      const double reach = 3.0 * scene.harness.cables[clip.cable].sections.front().section.radius;
      EXPECT_LT(distanceToComponent(scene, component, clip.pose.position, reach), reach)
          << file << ": " << clip.name << " is in the air";
    }
  }
}

// But for what it has contact with.
TEST(Clearance, NoCableTouchesAPartBetweenItsClips) {
  for (const std::string& file : sceneFiles()) {
    const Scene scene = readShipped(file);
    const Equilibrium equilibrium = EquilibriumSolver().solve(scene.harness);
    ASSERT_TRUE(equilibrium.converged()) << file << ": " << equilibrium.message;
    for (const CableShape& shape : equilibrium.shapes) {
      const double length = shape.points.back().arc_length;
      // At its ends a cable meets the connector or stub it belongs to.
      const double first = 1.5 * shape.radius, last = length - first;
      const double step = 0.002;
      for (double s = first; s < last; s += step) {
        for (const Component& component : scene.components) {
          const bool may_touch =
              std::any_of(scene.harness.contacts.begin(), scene.harness.contacts.end(),
                          [&](const PartContact& contact) { return contact.part == component.name; });
          if (may_touch) continue;
          const double clearance =
              distanceToComponent(scene, component, shape.position(s), 2.0 * shape.radius) - shape.radius;
          EXPECT_GT(clearance, 0.001)
              << file << ": " << shape.cable << " at " << s << " m, " << component.name;
        }
      }
    }
  }
}

}  // namespace
}  // namespace cable_variation
