#include <hunt/slenderness.h>

#include <hunt/part_maker.h>

namespace cable_variation::hunt {
namespace {

using Eigen::Vector3d;

constexpr double kLength = 1.0;

// A round wire of steel has κ = 4 (L/r)²; beyond, a bundle whose wires slide on each other: the EA of their
// metal, the sum of their EI.
Cable slenderCable(double kappa) {
  constexpr double kRadius = 0.6e-3;
  const Section wire = solidSection(kRadius, {210e9, 0.3, 7850.0});
  Section section = wire;
  const double softer = wire.EA * kLength * kLength / kappa / wire.EI_y;
  for (double* stiffness : {&section.GJ, &section.EI_y, &section.EI_z}) *stiffness *= softer;
  // as heavy against its bending stiffness as the wire is
  section.mass_per_length *= softer;
  section.young_modulus = section.shear_modulus = 0.0;
  return makeCable("wire", kLength, section);
}

}  // namespace

const char* toString(Setting setting) {
  switch (setting) {
    case Setting::fixed_ends:
      return "fixed ends";
    case Setting::eyelet:
      return "+ eyelet";
    case Setting::sliding_rolling:
      return "+ sliding_rolling";
    case Setting::sliding:
      return "+ sliding";
    case Setting::free_end:
      return "one end free";
    case Setting::aligned_clamps:
      return "aligned clamps with slack";
  }
  return "unknown";
}

Harness alignedClamps(double kappa, double slack) {
  Harness harness;
  harness.gravity = Vector3d::Zero();
  harness.cables = {slenderCable(kappa)};
  const Pose end{Vector3d((1.0 - slack) * kLength, 0.0, 0.0), Eigen::Quaterniond::Identity()};
  harness.clips = {makeClip("start", 0, 0.0, "fixed", fixedClip(), {}),
                   makeClip("end", 0, kLength, "fixed", fixedClip(), end)};
  return harness;
}

Harness slenderHarness(Draw& draw, Setting setting, double kappa) {
  if (setting == Setting::aligned_clamps) return alignedClamps(kappa, draw.between(0.02, 0.5));
  Harness harness;
  harness.cables = {slenderCable(kappa)};
  const Route route(draw, kLength, draw.between(0.3, 2.0), draw.between(0.7, 0.95));
  harness.clips.push_back(makeClip("start", 0, 0.0, "fixed", fixedClip(), disturbed(draw, {}, 0.5)));
  if (setting == Setting::free_end) return harness;
  const double s = draw.between(0.35, 0.65) * kLength;
  const Pose ring = disturbed(draw, route.at(s), 0.3);
  if (setting == Setting::eyelet) {
    harness.clips.push_back(makeClip("ring", 0, s, "eyelet", eyeletClip(), ring));
  } else if (setting == Setting::sliding_rolling) {
    harness.clips.push_back(makeClip("ring", 0, s, "sliding_rolling", slidingRollingClip(), ring));
  } else if (setting == Setting::sliding) {
    harness.clips.push_back(makeClip("ring", 0, s, "sliding", slidingClip(), ring));
  }
  const Pose end = disturbed(draw, route.at(kLength), 0.5);
  harness.clips.push_back(makeClip("end", 0, kLength, "fixed", fixedClip(), end));
  return harness;
}

}  // namespace cable_variation::hunt
