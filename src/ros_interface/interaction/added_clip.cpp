#include <ros_interface/interaction/added_clip.h>

#include <algorithm>
#include <limits>

#include <cable_variation/equilibrium/require_converged.h>
#include <cable_variation/geometry/mesh/surface_triangle.h>
#include <ros_interface/context/solver_context.h>
#include <ros_interface/node/names.h>

namespace cable_variation_ros {

using cable_variation::Component;
using cable_variation::Pose;

namespace {

constexpr double kFar = std::numeric_limits<double>::infinity();

struct Place {
  std::size_t cable = 0;
  double arc_length = 0.0;  // [m]
};

Place nearestPlace(const SolverContext& context, const Eigen::Vector3d& point, const std::string& cable) {
  constexpr double kStep = 1e-3;  // [m]: a person points no better
  Place nearest;
  double least = kFar;
  for (std::size_t i = 0; i < context.harness().cables.size(); ++i) {
    const cable_variation::Cable& each = context.harness().cables[i];
    if (!cable.empty() && each.name != cable) continue;
    const auto steps = static_cast<std::size_t>(each.length / kStep) + 1;
    for (std::size_t k = 0; k <= steps; ++k) {
      const double s = each.length * static_cast<double>(k) / static_cast<double>(steps);
      const double distance = (context.equilibrium().shapes[i].position(s) - point).norm();
      if (distance >= least) continue;
      least = distance;
      nearest = {i, s};
    }
  }
  return nearest;
}

double distanceTo(const Component& component, const Pose& pose, const Eigen::Vector3d& point) {
  double least = kFar;
  for (const cable_variation::Visual& visual : component.visuals) {
    if (!visual.mesh) continue;
    const Eigen::Vector3d local = (pose * visual.pose).inverse() * point;
    for (const auto& triangle : visual.mesh->triangles) {
      const auto corner = [&](std::size_t k) { return visual.mesh->vertices[triangle[k]]; };
      const cable_variation::SurfaceTriangle surface(corner(0), corner(1), corner(2));
      least = std::min(least, nearestPoint(surface, local).distance);
    }
  }
  return least;
}

std::string nearestComponent(const SolverContext& context, const Eigen::Vector3d& point) {
  std::string nearest = kWorldFrame;
  double least = kFar;
  const cable_variation::ComponentPoses poses = context.components();
  for (const Component& component : context.design().scene.components) {
    const double distance = distanceTo(component, poses.at(component.name), point);
    if (distance >= least) continue;
    least = distance;
    nearest = component.name;
  }
  return nearest;
}

std::string freeName(const cable_variation::Harness& harness) {
  for (std::size_t number = 1;; ++number) {
    std::string name = "clip_" + std::to_string(number);
    const bool taken = std::any_of(harness.clips.begin(), harness.clips.end(),
                                   [&](const cable_variation::Clip& clip) { return clip.name == name; });
    if (!taken) return name;
  }
}

}  // namespace

AddedClip clipAt(const SolverContext& context, const Eigen::Vector3d& point, const std::string& type,
                 const std::string& cable, const std::string& component) {
  requireConverged(context.equilibrium());
  const Place place = nearestPlace(context, point, cable);
  const Pose section = context.equilibrium().shapes[place.cable].pose(place.arc_length);
  AddedClip added;
  added.clip.name = freeName(context.harness());
  added.clip.type = type;
  added.clip.cable = place.cable;
  added.clip.arc_length = place.arc_length;
  added.mount.component = component.empty() ? nearestComponent(context, section.position) : component;
  const Pose carrier =
      added.mount.component == kWorldFrame ? Pose() : context.components().at(added.mount.component);
  added.mount.pose = carrier.inverse() * section;
  return added;
}

}  // namespace cable_variation_ros
