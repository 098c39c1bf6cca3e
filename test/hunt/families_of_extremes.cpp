// Where one stiffness or weight is far above another.

#include <hunt/family.h>
#include <hunt/part_maker.h>
#include <hunt/slenderness.h>

namespace cable_variation::hunt {

using Eigen::Quaterniond;
using Eigen::Vector3d;

Harness makeThinWire(Draw& draw) {
  const Section section = wireSection(draw, draw.logBetween(0.05e-3, 0.6e-3));
  const double length = draw.logBetween(0.3, 1.5);
  const Cable cable = makeCable("wire", length, section);
  Harness harness;
  harness.gravity = randomGravity(draw);
  harness.cables = {cable};
  const Route route(draw, length, draw.between(0.2, 2.0), draw.between(0.6, 0.97));
  harness.clips.push_back(makeClip("start", 0, 0.0, "fixed", fixedClip(), {}));
  if (draw.chance(0.5)) {
    const double s = draw.between(0.25, 0.75) * length;
    harness.clips.push_back(randomClip(draw, "middle", 0, s, cable, disturbed(draw, route.at(s), 0.3), true));
  }
  if (draw.chance(0.75)) {
    const Pose end = disturbed(draw, route.at(length), 0.4);
    harness.clips.push_back(makeClip("end", 0, length, "fixed", fixedClip(), end));
  }
  return harness;
}

Harness makeLongSoft(Draw& draw) {
  const double length = draw.logBetween(0.5, 5.0), mass = draw.logBetween(0.02, 1.0);
  const double EI = mass * 9.81 * length * length * length / draw.logBetween(1e3, 1e5);
  const double radius = draw.between(2e-3, 8e-3);
  const double EA = EI * draw.logBetween(0.3, 30.0) * 4.0 / (radius * radius);
  Cable cable =
      makeCable("cable", length, stiffnessSection(EA, EI, draw.between(0.5, 1.0) * EI, mass, radius));
  // no more stretch by its own weight than cables bear
  Section& section = cable.sections.front().section;
  section.EA = std::max(section.EA, 100.0 * mass * 9.81 * length);
  section.GA_y = section.GA_z = 0.4 * section.EA;
  if (draw.chance(0.3)) cable.twist = 0.0;
  Harness harness;
  harness.cables = {cable};
  const Vector3d chord = draw.between(0.1, 0.9) * length *
                         Vector3d(1.0, draw.between(-0.5, 0.5), draw.between(-0.7, 0.7)).normalized();
  const Quaterniond end = rotationBy({draw.between(-3.0, 3.0), 0.0, draw.between(-M_PI, M_PI)});
  harness.clips = {makeClip("start", 0, 0.0, "fixed", fixedClip(), {}),
                   makeClip("end", 0, length, "fixed", fixedClip(), {chord, end})};
  return harness;
}

Harness makeSlender(Draw& draw) {
  const auto setting = static_cast<Setting>(draw.index(6));
  return slenderHarness(draw, setting, draw.logBetween(1e7, 1e10));
}

}  // namespace cable_variation::hunt
