#include <hunt/part_maker.h>

#include <algorithm>
#include <cmath>

namespace cable_variation::hunt {

using Eigen::Quaterniond;
using Eigen::Vector3d;

Section stiffnessSection(double EA, double EI, double GJ, double mass_per_length, double radius) {
  const double GA = 0.4 * EA;
  return {EA, GA, GA, GJ, EI, EI, mass_per_length, radius};
}

Section bundleSection(Draw& draw) {
  const double radius = draw.logBetween(0.5e-3, 8e-3);
  const Material material{draw.logBetween(1e7, 5e9), 0.3, draw.between(1000.0, 6000.0)};
  if (draw.chance(0.2)) return hoseSection(radius, draw.between(0.6, 0.9) * radius, material);
  if (draw.chance(0.1)) {
    // lets y and z differ
    return rectangleSection(2.0 * radius, draw.between(0.3, 1.5) * radius, material);
  }
  Section section = solidSection(radius, material);
  if (draw.chance(0.5)) {
    const double softer = draw.logBetween(0.01, 1.0);
    section.EI_y *= softer;
    section.EI_z *= softer;
    section.GJ *= softer * draw.between(0.6, 1.4);
    section.young_modulus = section.shear_modulus = 0.0;
  }
  return section;
}

Section wireSection(Draw& draw, double radius) {
  const Material steel{210e9, 0.3, 7850.0}, copper{120e9, 0.34, 8900.0}, aluminium{70e9, 0.33, 2700.0};
  return solidSection(radius, draw.oneOf<Material>({steel, copper, aluminium}));
}

Cable makeCable(const std::string& name, double length, const Section& section) {
  Cable cable;
  cable.name = name;
  cable.length = length;
  cable.sections = {{0.0, section}};
  return cable;
}

Route::Route(Draw& draw, double length, double bend, double tightness)
    : Route(draw, length, bend, tightness, Pose()) {}

Route::Route(Draw& draw, double length, double bend, double tightness, const Pose& start)
    : length_(length), tightness_(tightness) {
  constexpr int kSteps = 200, kWaves = 3;
  Vector3d amplitude[kWaves];
  double phase[kWaves];
  for (int w = 0; w < kWaves; ++w) {
    amplitude[w] = bend * draw.between(0.3, 1.0) / (w + 1.0) * draw.direction();
    amplitude[w].x() *= 0.3;
    phase[w] = draw.between(0.0, 2.0 * M_PI);
  }
  Pose pose = start;
  poses_.push_back(pose);
  for (int i = 0; i < kSteps; ++i) {
    const double t = (i + 0.5) / kSteps;
    Vector3d curvature = Vector3d::Zero();
    for (int w = 0; w < kWaves; ++w) curvature += amplitude[w] * std::cos(phase[w] + M_PI * (w + 1) * t);
    const Quaterniond middle = pose.orientation * rotationBy(0.5 / kSteps * curvature);
    pose.position += length / kSteps * (middle * Vector3d::UnitX());
    pose.orientation = (pose.orientation * rotationBy(curvature / kSteps)).normalized();
    poses_.push_back(pose);
  }
}

Pose Route::at(double arc_length) const {
  const double place = std::clamp(arc_length / length_, 0.0, 1.0) * static_cast<double>(poses_.size() - 1);
  const auto i = std::min(static_cast<std::size_t>(place), poses_.size() - 2);
  const double t = place - static_cast<double>(i);
  const Pose &a = poses_[i], &b = poses_[i + 1];
  const Vector3d position = (1.0 - t) * a.position + t * b.position;
  const Vector3d& start = poses_.front().position;
  return {start + tightness_ * (position - start), a.orientation.slerp(t, b.orientation)};
}

Pose disturbed(Draw& draw, const Pose& pose, double angle) {
  return {pose.position, (pose.orientation * draw.turn(angle)).normalized()};
}

Clip makeClip(const std::string& name, std::size_t cable, double arc_length, const std::string& type,
              const ClipConstraint& constraint, const Pose& pose) {
  return {name, type, cable, arc_length, constraint, pose};
}

Clip randomClip(Draw& draw, const std::string& name, std::size_t cable, double arc_length, const Cable& of,
                const Pose& pose, bool may_slide) {
  const Section& section = of.sections.front().section;
  // springs from far softer to far stiffer than a tenth of the cable
  const double part = 0.1 * of.length;
  const auto turning = [&] { return draw.logBetween(0.01, 1000.0) * section.EI_y / part; };
  const auto pushing = [&] { return draw.logBetween(0.1, 1000.0) * section.EI_y / (part * part * part); };
  const auto general = [&](const auto& stiffness) {
    const double kind = draw.between(0.0, 1.0);
    if (kind < 0.4) return ClipFreedom::locked();
    return kind < 0.7 ? ClipFreedom::free() : ClipFreedom::sprung(stiffness());
  };
  const auto axis = [&] { return draw.oneOf<Axis>({Axis::x, Axis::y, Axis::z}); };
  const auto make = [&](const std::string& type, const ClipConstraint& constraint) {
    return makeClip(name, cable, arc_length, type, constraint, pose);
  };
  switch (draw.index(may_slide ? 13 : 9)) {
    case 0:
      return make("fixed", fixedClip());
    case 1:
      return make("rolling", rollingClip());
    case 2:
      return make("pivot", pivotClip());
    case 3:
      return make("general", hingeClip(axis()));
    case 4:
      return make("general", guideClip(draw.chance(0.5)));
    case 5:
      return make("general", planeClip(axis()));
    case 6: {
      const GrommetStiffness stiffness{pushing(), pushing(), turning(), turning()};
      return make("general", grommetClip(stiffness, may_slide && draw.chance(0.3)));
    }
    case 7:
    case 8: {
      ClipConstraint constraint;
      for (ClipFreedom& freedom : constraint.translation) freedom = general(pushing);
      for (ClipFreedom& freedom : constraint.rotation) freedom = general(turning);
      constraint.slides =
          may_slide && draw.chance(0.3) && constraint.translation[0].kind == ClipFreedom::Kind::locked;
      return make("general", constraint);
    }
    case 9:
      return make("sliding", slidingClip());
    case 10:
      return make("sliding_rolling", slidingRollingClip());
    default:
      return make("eyelet", eyeletClip());
  }
}

Vector3d randomGravity(Draw& draw) {
  const double kind = draw.between(0.0, 1.0);
  if (kind < 0.25) return Vector3d::Zero();
  if (kind < 0.6) return {0.0, 0.0, -9.81};
  return 9.81 * draw.direction();
}

}  // namespace cable_variation::hunt
