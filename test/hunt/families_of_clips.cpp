// One cable with clips along it, or with a free end.

#include <hunt/family.h>
#include <hunt/part_maker.h>

namespace cable_variation::hunt {
namespace {

using Eigen::Vector3d;

Harness oneCable(Draw& draw, const Cable& cable) {
  Harness harness;
  harness.gravity = randomGravity(draw);
  harness.cables = {cable};
  return harness;
}

Cable randomCable(Draw& draw) {
  const Section section = bundleSection(draw);
  return makeCable("cable", section.radius * draw.logBetween(60.0, 400.0), section);
}

std::string numbered(const char* name, std::size_t i) { return name + std::to_string(i); }

ClipConstraint randomSlide(Draw& draw) {
  return draw.oneOf<ClipConstraint>({slidingClip(), slidingRollingClip(), eyeletClip()});
}

}  // namespace

Harness makeSeveralClips(Draw& draw) {
  const Section section = bundleSection(draw);
  const Cable cable = makeCable("cable", section.radius * draw.logBetween(30.0, 400.0), section);
  Harness harness = oneCable(draw, cable);
  const double tightness = draw.chance(0.05) ? draw.between(1.08, 1.3) : draw.between(0.5, 0.97);
  const Route route(draw, cable.length, draw.between(0.2, 3.0), tightness);
  const double crooked = draw.between(0.02, 0.5);
  const std::size_t count = draw.count(1, 4);
  harness.clips.push_back(makeClip("start", 0, 0.0, "fixed", fixedClip(), route.at(0.0)));
  for (std::size_t i = 0; i < count; ++i) {
    const double s =
        cable.length * (static_cast<double>(i) + draw.between(0.7, 1.3)) / static_cast<double>(count + 1);
    const Pose pose = disturbed(draw, route.at(s), crooked);
    harness.clips.push_back(randomClip(draw, numbered("clip", i), 0, s, cable, pose, true));
  }
  if (draw.chance(0.7)) {
    const Pose pose = disturbed(draw, route.at(cable.length), crooked);
    harness.clips.push_back(randomClip(draw, "end", 0, cable.length, cable, pose, false));
  }
  return harness;
}

Harness makeSlidingNearEnd(Draw& draw) {
  const Cable cable = randomCable(draw);
  Harness harness = oneCable(draw, cable);
  const Route route(draw, cable.length, draw.between(0.2, 2.0), draw.between(0.7, 0.97));
  const double s = cable.length * (1.0 - draw.logBetween(0.02, 0.15));
  harness.clips.push_back(makeClip("start", 0, 0.0, "fixed", fixedClip(), {}));
  harness.clips.push_back(
      makeClip("slide", 0, s, "general", randomSlide(draw), disturbed(draw, route.at(s), 0.15)));
  if (draw.chance(0.7)) {
    const Pose end = disturbed(draw, route.at(cable.length), 0.15);
    harness.clips.push_back(makeClip("end", 0, cable.length, "fixed", fixedClip(), end));
  }
  return harness;
}

Harness makeTwoSlides(Draw& draw) {
  const Cable cable = randomCable(draw);
  Harness harness = oneCable(draw, cable);
  const Route route(draw, cable.length, draw.between(0.2, 2.5), draw.between(0.6, 0.95));
  const double first = cable.length * draw.between(0.2, 0.45),
               second = cable.length * draw.between(0.55, 0.8);
  harness.clips.push_back(makeClip("start", 0, 0.0, "fixed", fixedClip(), {}));
  harness.clips.push_back(
      makeClip("slide1", 0, first, "general", randomSlide(draw), disturbed(draw, route.at(first), 0.3)));
  harness.clips.push_back(
      makeClip("slide2", 0, second, "general", randomSlide(draw), disturbed(draw, route.at(second), 0.3)));
  const Pose end = disturbed(draw, route.at(cable.length), 0.3);
  harness.clips.push_back(makeClip("end", 0, cable.length, "fixed", fixedClip(), end));
  return harness;
}

Harness makeFreeEnds(Draw& draw) {
  const Cable cable = randomCable(draw);
  Harness harness = oneCable(draw, cable);
  const bool both = draw.chance(0.5);
  const double s = both ? cable.length * draw.between(0.2, 0.8) : 0.0;
  harness.clips.push_back(makeClip("hold", 0, s, "fixed", fixedClip(), disturbed(draw, {}, M_PI)));
  if (both && draw.chance(0.5)) {
    const double there = s + draw.between(0.2, 0.8) * (cable.length - s);
    const Vector3d away = 0.8 * (there - s) * (harness.clips[0].pose.orientation * Vector3d::UnitX());
    const Pose pose = disturbed(draw, {away, harness.clips[0].pose.orientation}, 0.4);
    harness.clips.push_back(randomClip(draw, "second", 0, there, cable, pose, true));
  }
  return harness;
}

Harness makeHeavyTip(Draw& draw) {
  const Cable cable = randomCable(draw);
  Harness harness = oneCable(draw, cable);
  harness.clips.push_back(makeClip("hold", 0, 0.0, "fixed", fixedClip(), disturbed(draw, {}, M_PI)));
  const double bending = cable.sections.front().section.EI_y / (cable.length * cable.length);
  PointLoad tip;
  tip.name = "tip";
  tip.arc_length = draw.chance(0.8) ? cable.length : draw.between(0.4, 0.9) * cable.length;
  tip.force = std::min(draw.logBetween(0.5, 300.0) * bending, 0.02 * cable.sections.front().section.EA) *
              Vector3d(0.0, 0.0, -1.0);
  harness.loads.push_back(tip);
  return harness;
}

}  // namespace cable_variation::hunt
