#include <ros_interface/markers/clip_markers.h>

#include <algorithm>
#include <array>
#include <cmath>

#include <cable_variation/geometry/tube_distance/tube.h>
#include <cable_variation/harness/clip_preset.h>
#include <ros_interface/markers/marker_shapes.h>
#include <ros_interface/node/names.h>

namespace cable_variation_ros {

using cable_variation::Clip;
using cable_variation::ClipFreedom;
using cable_variation::ClipPreset;
using cable_variation::enumeratorCount;
using cable_variation::Harness;
using cable_variation::Pose;
using cable_variation::TriangleMesh;

namespace {

/// Draws in the clip's frame, in units of the cable's radius.
struct Drawing {
  MarkerGroup& group;
  const Clip& clip;
  double radius;

  void box(const Eigen::Vector3d& centre, const Eigen::Vector3d& size) const {
    group.addBox(clip.pose * Pose{radius * centre, Eigen::Quaterniond::Identity()}, radius * size);
  }
  void cylinder(const Eigen::Vector3d& from, const Eigen::Vector3d& to, double r) const {
    group.addCylinder(clip.pose * Eigen::Vector3d(radius * from), clip.pose * Eigen::Vector3d(radius * to),
                      radius * r);
  }
  /// A hoop around the cable.
  void ring(double hoop_radius, double wire_radius) const {
    constexpr int kSteps = 40;
    constexpr std::size_t kSides = 20;
    std::vector<Pose> path;
    for (int i = 0; i < kSteps; ++i) {
      const Eigen::Quaterniond turn(Eigen::AngleAxisd(2.0 * M_PI * i / kSteps, Eigen::Vector3d::UnitX()));
      const Eigen::Quaterniond tangent_along_z =
          Eigen::Quaterniond::FromTwoVectors(Eigen::Vector3d::UnitX(), Eigen::Vector3d::UnitZ());
      path.push_back({turn * Eigen::Vector3d(0.0, radius * hoop_radius, 0.0), turn * tangent_along_z});
    }
    group.addMesh(clip.pose, tubeMesh(path, radius * wire_radius, kSides, true));
  }
};

/// The axis of the first of three freedoms that is `kind`; z if none is.
Eigen::Vector3d axisOf(const std::array<ClipFreedom, 3>& freedoms, ClipFreedom::Kind kind) {
  for (int i = 0; i < 3; ++i) {
    if (freedoms[static_cast<std::size_t>(i)].kind == kind) return Eigen::Vector3d::Unit(i);
  }
  return Eigen::Vector3d::UnitZ();
}

struct ClipLook {
  ClipPreset preset;
  std::array<double, 4> color;  // red, green, blue, alpha
  void (*draw)(const Drawing&);
};

const Eigen::Vector3d kX = Eigen::Vector3d::UnitX();
const Eigen::Vector3d kY = Eigen::Vector3d::UnitY();
const Eigen::Vector3d kZ = Eigen::Vector3d::UnitZ();

void drawFixed(const Drawing& d) {
  d.box({0.0, 0.0, 0.0}, {3.0, 3.2, 3.2});
  d.box({0.0, 0.0, 0.0}, {1.2, 3.8, 3.8});
}

void drawRolling(const Drawing& d) {
  d.cylinder(-1.1 * kX, 1.1 * kX, 1.35);
  d.box({0.0, 2.4, -1.1}, {2.2, 2.6, 0.35});
}

void drawPivot(const Drawing& d) {
  d.group.addSphere(d.clip.pose.position, 1.9 * d.radius);
  d.cylinder(-2.6 * kZ, -1.2 * kZ, 1.3);
}

void drawHinge(const Drawing& d) {
  const Eigen::Vector3d pin = axisOf(d.clip.constraint.rotation, ClipFreedom::Kind::free);
  d.cylinder(-1.1 * kX, 1.1 * kX, 1.4);
  d.cylinder(-3.4 * pin, 3.4 * pin, 0.55);
}

void drawSliding(const Drawing& d) {
  for (const double side : {-1.3, 1.3}) {
    d.box(side * kY, {5.0, 0.5, 3.1});
    d.box(side * kZ, {5.0, 3.1, 0.5});
  }
}

void drawSlidingRolling(const Drawing& d) {
  d.cylinder(-2.5 * kX, 2.5 * kX, 1.3);
  d.cylinder(-2.5 * kX, -2.0 * kX, 1.6);
  d.cylinder(2.0 * kX, 2.5 * kX, 1.6);
}

void drawEyelet(const Drawing& d) { d.ring(1.6, 0.4); }

void drawGuide(const Drawing& d) {
  for (const double side : {-1.35, 1.35}) d.box(side * kY, {10.0, 0.5, 3.2});
  d.box(-1.35 * kZ, {10.0, 3.2, 0.5});
}

void drawPlane(const Drawing& d) {
  const Eigen::Vector3d normal = axisOf(d.clip.constraint.translation, ClipFreedom::Kind::locked);
  d.box(-1.15 * normal, Eigen::Vector3d::Constant(8.0) - 7.7 * normal);
}

void drawGrommet(const Drawing& d) {
  d.cylinder(-0.9 * kX, -0.35 * kX, 2.4);
  d.cylinder(-0.4 * kX, 0.4 * kX, 1.9);
  d.cylinder(0.35 * kX, 0.9 * kX, 2.4);
}

void drawFree(const Drawing& d) {
  for (int i = 0; i < 6; ++i) d.cylinder((1.2 + 0.3 * i) * kX, (1.5 + 0.3 * i) * kX, 1.2 - 0.2 * i);
}

void drawGeneral(const Drawing& d) { d.box(Eigen::Vector3d::Zero(), {2.4, 2.6, 2.6}); }

constexpr std::array<ClipLook, enumeratorCount<ClipPreset>()> kLooks{{
    {ClipPreset::fixed, {0.20, 0.36, 0.62, 1.0}, drawFixed},
    {ClipPreset::rolling, {0.10, 0.58, 0.58, 1.0}, drawRolling},
    {ClipPreset::pivot, {0.52, 0.32, 0.75, 1.0}, drawPivot},
    {ClipPreset::hinge, {0.36, 0.34, 0.80, 1.0}, drawHinge},
    {ClipPreset::sliding, {0.16, 0.55, 0.24, 1.0}, drawSliding},
    {ClipPreset::sliding_rolling, {0.42, 0.66, 0.16, 1.0}, drawSlidingRolling},
    {ClipPreset::eyelet, {0.86, 0.78, 0.30, 1.0}, drawEyelet},
    {ClipPreset::guide, {0.12, 0.52, 0.72, 1.0}, drawGuide},
    {ClipPreset::plane, {0.62, 0.72, 0.82, 1.0}, drawPlane},
    {ClipPreset::grommet, {0.13, 0.13, 0.14, 1.0}, drawGrommet},
    {ClipPreset::general, {0.45, 0.48, 0.54, 1.0}, drawGeneral},
    {ClipPreset::free, {0.92, 0.92, 0.94, 1.0}, drawFree},
}};
static_assert(hasRowOfEach(kLooks, &ClipLook::preset), "a preset is not drawn, or is out of order");

constexpr double kTextHeight = 0.009;      // [m]; readable where a whole cable fills the view
constexpr double kOpenAlpha = 0.3;         // of a clip that holds nothing
constexpr double kSmallestRadius = 0.002;  // a clip is drawn as for a cable this thick at least [m]

}  // namespace

visualization_msgs::MarkerArray clipMarkers(const cable_variation::Equilibrium& equilibrium,
                                            const Harness& harness, bool named) {
  visualization_msgs::MarkerArray array;
  for (std::size_t i = 0; i < harness.clips.size(); ++i) {
    Clip clip = harness.clips[i];
    if (!isMounted(clip)) {
      if (!equilibrium.converged()) continue;
      clip.pose = equilibrium.clip_reactions[i].section;
    }
    const double cable_radius = sectionAt(harness.cables[clip.cable], clip.arc_length).radius;
    const double radius = std::max(cable_radius, kSmallestRadius);
    const ClipLook& look = kLooks[static_cast<std::size_t>(presetOf(clip))];
    Eigen::Vector4d color(look.color.data());
    if (!clip.attached) color.w() = kOpenAlpha;
    MarkerGroup group(kClipMarkers + clip.name, kWorldFrame, color);
    look.draw({group, clip, radius});
    if (named) {
      group.setColor({0.96, 0.97, 0.98, 1.0});
      group.addText(clip.pose.position + (3.2 * radius + kTextHeight) * kZ,
                    clip.attached ? clip.name : clip.name + " (open)", kTextHeight);
    }
    array.markers.insert(array.markers.end(), group.markers().begin(), group.markers().end());
  }
  return array;
}

}  // namespace cable_variation_ros
