#include <ros_interface/interaction/added_cable.h>

#include <algorithm>
#include <utility>

#include <Eigen/Geometry>

#include <cable_variation/math/pose.h>
#include <cable_variation/rod/section.h>
#include <ros_interface/context/solver_context.h>
#include <ros_interface/node/names.h>

namespace cable_variation_ros {

using cable_variation::Component;
using cable_variation::Pose;

namespace {

constexpr double kRadius = 4e-3;                              // [m]
constexpr cable_variation::Material kBundle{1e8, 0.25, 2e3};  // Pa, 1, kg/m³
constexpr double kShortest = 0.05, kLongest = 1.0;            // [m]
constexpr double kSpan = 0.9;                                 // of its length, between its ends

Eigen::AlignedBox3d boxOf(const Component& component, const Pose& pose) {
  Eigen::AlignedBox3d box;
  for (const cable_variation::Visual& visual : component.visuals) {
    if (!visual.mesh) continue;
    const Pose place = pose * visual.pose;
    for (const Eigen::Vector3d& vertex : visual.mesh->vertices) box.extend(place * vertex);
  }
  return box;
}

template <typename Named>
std::string freeName(const std::string& stem, const std::vector<Named>& all, std::size_t from) {
  for (std::size_t number = from;; ++number) {
    const std::string name = stem + std::to_string(number);
    if (std::none_of(all.begin(), all.end(), [&](const Named& each) { return each.name == name; }))
      return name;
  }
}

/// x along the cable, in the world.
Pose endPose(const Eigen::Vector3d& position, const Eigen::Vector3d& along) {
  Pose pose;
  pose.position = position;
  pose.orientation = Eigen::Quaterniond::FromTwoVectors(Eigen::Vector3d::UnitX(), along);
  return pose;
}

}  // namespace

AddedCable cableAt(const SolverContext& context, const Eigen::Vector3d& point, const std::string& component) {
  const cable_variation::Scene& scene = context.design().scene;
  const cable_variation::Harness& harness = scene.harness;
  const auto part = std::find_if(scene.components.begin(), scene.components.end(),
                                 [&](const Component& each) { return each.name == component; });
  const Pose carrier = part == scene.components.end() ? Pose() : context.components().at(component);
  Eigen::Vector3d sides = Eigen::Vector3d::Zero();
  if (part != scene.components.end()) {
    const Eigen::AlignedBox3d box = boxOf(*part, carrier);
    if (!box.isEmpty()) sides = box.sizes();
  }
  const Eigen::Vector3d up = harness.gravity.norm() > 0.0 ? Eigen::Vector3d(-harness.gravity.normalized())
                                                          : Eigen::Vector3d(Eigen::Vector3d::UnitZ());
  Eigen::Index longest = 0;
  (sides.array() * (1.0 - up.array().abs())).maxCoeff(&longest);
  Eigen::Vector3d along = Eigen::Vector3d::Unit(longest);
  along = (along - along.dot(up) * up).norm() > 0.5
              ? Eigen::Vector3d((along - along.dot(up) * up).normalized())
              : up.unitOrthogonal();

  AddedCable added;
  added.cable.name = freeName("cable_", harness.cables, 1);
  added.cable.length = std::clamp(0.5 * sides.maxCoeff(), kShortest, kLongest);
  added.cable.sections = {{0.0, cable_variation::solidSection(kRadius, kBundle)}};
  const Eigen::Vector3d middle = point + 0.1 * added.cable.length * up;
  std::size_t number = 1;
  for (std::size_t i = 0; i < added.ends.size(); ++i) {
    AddedClip& end = added.ends[i];
    end.clip.name = freeName("clip_", harness.clips, number);
    number = std::stoul(end.clip.name.substr(5)) + 1;
    end.clip.type = "fixed";
    end.clip.cable = harness.cables.size();
    end.clip.arc_length = i == 0 ? 0.0 : added.cable.length;
    end.mount.component = part == scene.components.end() ? std::string(kWorldFrame) : component;
    const double side = (i == 0 ? -0.5 : 0.5) * kSpan * added.cable.length;
    end.mount.pose = carrier.inverse() * endPose(middle + side * along, along);
  }
  return added;
}

}  // namespace cable_variation_ros
