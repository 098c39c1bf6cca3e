// One cable, held at its ends.

#include <hunt/family.h>
#include <hunt/part_maker.h>

namespace cable_variation::hunt {
namespace {

using Eigen::Quaterniond;
using Eigen::Vector3d;

Harness between(Draw& draw, const Cable& cable, const Pose& start, const Pose& end) {
  Harness harness;
  harness.gravity = randomGravity(draw);
  harness.cables = {cable};
  harness.clips = {makeClip("start", 0, 0.0, "fixed", fixedClip(), start),
                   makeClip("end", 0, cable.length, "fixed", fixedClip(), end)};
  return harness;
}

Cable randomCable(Draw& draw) {
  const Section section = bundleSection(draw);
  return makeCable("cable", section.radius * draw.logBetween(40.0, 400.0), section);
}

}  // namespace

// Stubby cables among them, which clips press more than cables bear, and some that are too short.
Harness makeTwoEnds(Draw& draw) {
  const Section section = bundleSection(draw);
  const Cable cable = makeCable("cable", section.radius * draw.logBetween(12.0, 400.0), section);
  const double tightness = draw.chance(0.05) ? draw.between(1.08, 1.4) : draw.between(0.5, 0.98);
  const Route route(draw, cable.length, draw.between(0.2, 2.5), tightness);
  Harness harness = between(draw, cable, {}, disturbed(draw, route.at(cable.length), 0.4));
  if (draw.chance(0.3)) {
    const auto ends = {rollingClip(), pivotClip(), hingeClip(Axis::y), hingeClip(Axis::z)};
    harness.clips[1].constraint = draw.oneOf<ClipConstraint>(ends);
    harness.clips[1].type = "general";
  }
  return harness;
}

Harness makeAnyOrientation(Draw& draw) {
  const Cable cable = randomCable(draw);
  const Vector3d chord = draw.between(0.2, 0.85) * cable.length * draw.direction();
  return between(draw, cable, disturbed(draw, {}, M_PI),
                 disturbed(draw, {chord, Quaterniond::Identity()}, M_PI));
}

Harness makeFlippedEnds(Draw& draw) {
  const Cable cable = randomCable(draw);
  const Vector3d chord =
      draw.between(0.05, 0.6) * cable.length * (Vector3d::UnitX() + 0.3 * draw.direction());
  const double flip = M_PI * draw.between(0.9, 1.1);
  const Vector3d about = draw.oneOf<Vector3d>({Vector3d::UnitX(), Vector3d::UnitY(), Vector3d::UnitZ()});
  return between(draw, cable, {}, disturbed(draw, {chord, rotationBy(flip * about)}, 0.2));
}

Harness makeTwistHint(Draw& draw) {
  Cable cable = randomCable(draw);
  // so taut that twist cannot turn into writhe: between guided ends under tension
  const double turns = static_cast<double>(draw.count(0, 12)) - 6.0;
  cable.twist = 2.0 * M_PI * turns + draw.between(-0.5, 0.5);
  const Pose end{Vector3d(cable.length, 0.0, 0.0), rotationBy({*cable.twist, 0.0, 0.0})};
  Harness harness = between(draw, cable, {}, end);
  harness.gravity = Vector3d::Zero();
  harness.clips[1].constraint = guideClip();
  harness.clips[1].type = "general";
  const Section& section = cable.sections.front().section;
  const double moment = section.GJ * std::abs(*cable.twist) / cable.length;
  const double softest = std::min(section.EI_y, section.EI_z);
  // a pinned rod of that moment needs a pull of T²/4EI; and no more than the cable bears
  PointLoad pull;
  pull.name = "pull";
  pull.arc_length = cable.length;
  pull.force.x() =
      draw.between(1.5, 4.0) * (moment * moment / (4.0 * softest) + softest / (cable.length * cable.length));
  pull.force.x() = std::min(pull.force.x(), 0.02 * section.EA);
  harness.loads = {pull};
  return harness;
}

Harness makePitchfork(Draw& draw) {
  const Cable cable = randomCable(draw);
  const double pressed = draw.logBetween(1e-3, 0.2);
  // nearly symmetric: what decides the side is small
  const double aside = draw.logBetween(1e-6, 1e-2);
  const Pose end =
      disturbed(draw, {cable.length * (1.0 - pressed) * Vector3d::UnitX(), Quaterniond::Identity()}, aside);
  Harness harness = between(draw, cable, {}, end);
  harness.gravity *= draw.oneOf<double>({0.0, aside});
  if (draw.chance(0.4)) {
    harness.clips[0].constraint = hingeClip(Axis::y);
    harness.clips[1].constraint = draw.chance(0.5) ? hingeClip(Axis::y) : fixedClip();
    harness.clips[0].type = harness.clips[1].type = "general";
  }
  return harness;
}

Harness makeLongSlack(Draw& draw) {
  const Cable cable = randomCable(draw);
  const Pose end{draw.between(0.02, 0.4) * cable.length * draw.direction(), Quaterniond::Identity()};
  Harness harness = between(draw, cable, {}, disturbed(draw, end, M_PI));
  if (draw.chance(0.5)) {
    const double s = draw.between(0.2, 0.8) * cable.length;
    const Pose pose{0.5 * end.position + 0.1 * cable.length * draw.direction(), Quaterniond::Identity()};
    harness.clips.push_back(randomClip(draw, "middle", 0, s, cable, disturbed(draw, pose, 0.5), true));
  }
  return harness;
}

Harness makePreformed(Draw& draw) {
  Cable cable = randomCable(draw);
  const Section first = cable.sections.front().section;
  Section last = first;
  const double thicker = draw.between(0.5, 1.5);
  last.radius *= thicker;
  for (double* stiffness : {&last.EA, &last.GA_y, &last.GA_z, &last.mass_per_length})
    *stiffness *= thicker * thicker;
  for (double* stiffness : {&last.GJ, &last.EI_y, &last.EI_z}) *stiffness *= std::pow(thicker, 4);
  if (draw.chance(0.3)) {
    const double step = draw.between(0.3, 0.7) * cable.length;
    cable.sections = {{0.0, first}, {step, first}, {step, last}, {cable.length, last}};
  } else if (draw.chance(0.7)) {
    cable.sections = {{0.0, first}, {cable.length, last}};
  }
  const std::size_t knots = draw.count(3, 8);
  const double turn = draw.between(0.5, 5.0) / cable.length;
  for (std::size_t i = 0; i < knots; ++i) {
    Vector3d curvature = turn * draw.between(0.2, 1.0) * draw.direction();
    curvature.x() *= 0.2;
    cable.rest_curvature.push_back(
        {cable.length * static_cast<double>(i) / static_cast<double>(knots - 1), curvature});
  }
  const Route route(draw, cable.length, draw.between(0.5, 3.0), draw.between(0.5, 0.9));
  return between(draw, cable, {}, disturbed(draw, route.at(cable.length), 0.6));
}

}  // namespace cable_variation::hunt
