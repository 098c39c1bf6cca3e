// Cables joined to chains, trees and loops.

#include <hunt/family.h>
#include <hunt/part_maker.h>

namespace cable_variation::hunt {
namespace {

using Eigen::Quaterniond;
using Eigen::Vector3d;

std::string numbered(const char* name, std::size_t i) { return name + std::to_string(i); }

Joint join(const std::string& name, Joint::Type type, std::size_t parent, double at, std::size_t child,
           double child_at = 0.0) {
  Joint joint;
  joint.name = name;
  joint.type = type;
  joint.parent = parent;
  joint.parent_arc_length = at;
  joint.child = child;
  joint.child_arc_length = child_at;
  return joint;
}

Joint::Type randomJoint(Draw& draw) {
  const double kind = draw.between(0.0, 1.0);
  if (kind < 0.6) return Joint::Type::fixed;
  return kind < 0.8 ? Joint::Type::pivot : Joint::Type::hinge;
}

// A tree of `count` cables along random routes; each child leaves an earlier one, and is held somewhere.
// Clips that slide are as frequent as `sliding`.
Harness tree(Draw& draw, std::size_t count, double softest, double sliding) {
  Harness harness;
  harness.gravity = randomGravity(draw);
  const double tightness = draw.between(0.7, 0.95), crooked = draw.between(0.05, 0.4);
  std::vector<Route> routes;
  const Section main = bundleSection(draw);
  for (std::size_t i = 0; i < count; ++i) {
    Section section = main;
    const double softer = i == 0 ? 1.0 : draw.logBetween(softest, 1.0);
    for (double* stiffness : {&section.GJ, &section.EI_y, &section.EI_z}) *stiffness *= softer;
    for (double* stiffness : {&section.EA, &section.GA_y, &section.GA_z, &section.mass_per_length}) {
      *stiffness *= std::sqrt(softer);
    }
    const double length = main.radius * draw.logBetween(60.0, 250.0);
    harness.cables.push_back(makeCable(numbered("cable", i), length, section));
    if (i == 0) {
      routes.emplace_back(draw, length, draw.between(0.2, 2.0), tightness);
      harness.clips.push_back(makeClip("start0", 0, 0.0, "fixed", fixedClip(), routes[0].at(0.0)));
      if (draw.chance(0.7)) {
        const Pose end = disturbed(draw, routes[0].at(length), crooked);
        harness.clips.push_back(makeClip("end0", 0, length, "fixed", fixedClip(), end));
      }
      continue;
    }
    const std::size_t parent = draw.index(i);
    const double at = draw.between(0.2, 0.8) * harness.cables[parent].length;
    Joint joint = join(numbered("joint", i), randomJoint(draw), parent, at, i);
    Pose start = routes[parent].at(at);
    joint.rotation = joint.type == Joint::Type::pivot ? Quaterniond::Identity() : draw.turn(1.2);
    start.orientation = start.orientation * joint.rotation;
    harness.joints.push_back(joint);
    routes.emplace_back(draw, length, draw.between(0.2, 2.0), tightness, start);
    const double kind = draw.between(0.0, 1.0);
    if (kind < 0.75) {
      const Pose end = disturbed(draw, routes[i].at(length), crooked);
      harness.clips.push_back(makeClip(numbered("end", i), i, length, "fixed", fixedClip(), end));
    }
    if (kind > 0.5) {
      const double s = draw.between(0.3, 0.7) * length;
      const Pose pose = disturbed(draw, routes[i].at(s), crooked);
      harness.clips.push_back(
          randomClip(draw, numbered("clip", i), i, s, harness.cables[i], pose, draw.chance(sliding)));
    }
  }
  return harness;
}

}  // namespace

Harness makeBranches(Draw& draw) { return tree(draw, draw.count(2, 4), 0.1, 0.7); }

Harness makeStiffSoft(Draw& draw) { return tree(draw, 2, draw.logBetween(1e-4, 1e-2), 0.7); }

Harness makeBig(Draw& draw) { return tree(draw, draw.count(10, 14), 0.2, 0.15); }

Harness makeChain(Draw& draw) {
  const Section section = bundleSection(draw);
  const std::size_t count = draw.count(2, 6);
  const double length = section.radius * draw.logBetween(40.0, 150.0);
  Harness harness;
  harness.gravity = randomGravity(draw);
  for (std::size_t i = 0; i < count; ++i) {
    harness.cables.push_back(makeCable(numbered("cable", i), length, section));
    if (i == 0) continue;
    Joint joint = join(numbered("joint", i), draw.chance(0.6) ? Joint::Type::pivot : Joint::Type::hinge,
                       i - 1, length, i);
    if (joint.type == Joint::Type::hinge) {
      joint.axis = draw.oneOf<Vector3d>({Vector3d::UnitX(), Vector3d::UnitY(), Vector3d::UnitZ()});
    }
    harness.joints.push_back(joint);
  }
  const double whole = length * static_cast<double>(count);
  const Vector3d end = draw.between(0.4, 0.9) * whole * draw.direction();
  const bool turns = draw.chance(0.5);
  harness.clips = {
      makeClip("start", 0, 0.0, turns ? "pivot" : "fixed", turns ? pivotClip() : fixedClip(), {}),
      makeClip("end", count - 1, length, "fixed", fixedClip(),
               disturbed(draw, {end, Quaterniond::Identity()}, M_PI))};
  return harness;
}

// Two cables from one place of a third to another: closed by joints, or held at both ends.
Harness makeLoop(Draw& draw) {
  const Section section = bundleSection(draw);
  Harness harness;
  harness.gravity = randomGravity(draw);
  const double length = section.radius * draw.logBetween(80.0, 300.0);
  const Route route(draw, length, draw.between(0.2, 1.5), draw.between(0.75, 0.97));
  harness.cables.push_back(makeCable("main", length, section));
  harness.clips.push_back(makeClip("start", 0, 0.0, "fixed", fixedClip(), {}));
  if (draw.chance(0.6)) {
    const Pose end = disturbed(draw, route.at(length), 0.3);
    harness.clips.push_back(makeClip("end", 0, length, "fixed", fixedClip(), end));
  }
  const double from = draw.between(0.15, 0.4) * length, to = draw.between(0.6, 0.85) * length;
  const std::size_t loops = draw.count(1, 2);
  for (std::size_t i = 1; i <= loops; ++i) {
    Section softer = section;
    const double factor = draw.logBetween(0.05, 1.0);
    for (double* stiffness : {&softer.GJ, &softer.EI_y, &softer.EI_z}) *stiffness *= factor;
    const double across = (to - from) * draw.between(0.95, 2.0);
    harness.cables.push_back(makeCable(numbered("loop", i), across, softer));
    const double shift = 0.05 * length * static_cast<double>(i - 1);
    Joint first = join(numbered("first", i), randomJoint(draw), 0, from + shift, i);
    Joint second = join(numbered("second", i), randomJoint(draw), 0, to - shift, i, across);
    first.rotation = first.type == Joint::Type::pivot ? Quaterniond::Identity() : draw.turn(0.8);
    second.rotation = second.type == Joint::Type::pivot ? Quaterniond::Identity() : draw.turn(0.8);
    harness.joints.push_back(first);
    harness.joints.push_back(second);
  }
  return harness;
}

}  // namespace cable_variation::hunt
