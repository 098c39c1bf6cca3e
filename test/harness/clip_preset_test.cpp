// Each preset on the same loaded cable, told apart from its neighbours by what
// it holds (the section cannot leave) and what it lets go (no force that way).

#include <gtest/gtest.h>

#include <equilibrium/case_table.h>

namespace cable_variation::test {
namespace {

// A letter per axis of the clip: l locked, f free.
struct Preset {
  std::string name;
  ClipConstraint constraint;
  std::string translation, rotation;
  bool slides;
};

std::ostream& operator<<(std::ostream& out, const Preset& preset) { return out << preset.name; }

// The table of presets: position, rotation, s_c.
std::vector<Preset> presets() {
  return {{"fixed", fixedClip(), "lll", "lll", false},
          {"rolling", rollingClip(), "lll", "fll", false},
          {"pivot", pivotClip(), "lll", "fff", false},
          {"hinge_x", hingeClip(Axis::x), "lll", "fll", false},
          {"hinge_y", hingeClip(Axis::y), "lll", "lfl", false},
          {"hinge_z", hingeClip(Axis::z), "lll", "llf", false},
          {"sliding", slidingClip(), "lll", "lll", true},
          {"sliding_rolling", slidingRollingClip(), "lll", "fll", true},
          {"eyelet", eyeletClip(), "lll", "fff", true},
          {"guide", guideClip(), "fll", "lll", false},
          {"guide_rolling", guideClip(true), "fll", "fll", false},
          {"plane_x", planeClip(Axis::x), "lff", "fff", false},
          {"plane_y", planeClip(Axis::y), "flf", "fff", false},
          {"plane_z", planeClip(Axis::z), "ffl", "fff", false},
          {"free", freeClip(), "fff", "fff", false}};
}

// h = Rᵀf·eₓ + ½ fᵀRK⁻¹Rᵀf + ½ mᵀRK⁻¹Rᵀm + Ω₀·Rᵀm, the configurational force [N]
double configurationalForce(const ShapePoint& point) {
  const Eigen::Vector3d n = point.pose.orientation.conjugate() * point.force;
  const Eigen::Vector3d m = point.pose.orientation.conjugate() * point.moment;
  const Eigen::Vector3d rest = point.darboux - point.curvature;
  return n.x() + 0.5 * n.dot(point.strain) + 0.5 * m.dot(point.curvature) + rest.dot(m);
}

class ClipPreset : public testing::TestWithParam<Preset> {};

TEST_P(ClipPreset, HoldsWhatItLocksAndLetsGoWhatItFrees) {
  const Preset& preset = GetParam();
  // the pre-formed hose: intrinsic curvature takes part in the configurational force
  const Harness harness = heldBetween(cableKinds().back().cable, preset.constraint);
  const Equilibrium result = solve(harness, 1e-8);
  ASSERT_TRUE(result.converged()) << result.message;
  const Pose& frame = harness.clips[2].pose;
  const Reaction& reaction = result.clip_reactions[2];
  const Pose held = frame.inverse() * reaction.section;
  const Eigen::Vector3d turn = so3::log(held.orientation);
  const Eigen::Vector3d force = frame.orientation.conjugate() * reaction.force;
  const Eigen::Vector3d moment = frame.orientation.conjugate() * reaction.moment;
  for (int k = 0; k < 3; ++k) {
    // locked: to rounding, with a reaction that is clearly there (forces of newtons, moments of 0.1 N m);
    // free: moved away by more than 0.1 mm and 0.5 deg, with no reaction
    if (preset.translation[static_cast<std::size_t>(k)] == 'l') {
      EXPECT_LT(std::abs(held.position[k]), 1e-14) << "position along axis " << k;
      EXPECT_GT(std::abs(force[k]), 1e-2) << "force along axis " << k;
    } else {
      EXPECT_GT(std::abs(held.position[k]), 1e-4) << "position along axis " << k;
      EXPECT_LT(std::abs(force[k]), 1e-8) << "force along axis " << k;
    }
    if (preset.rotation[static_cast<std::size_t>(k)] == 'l') {
      EXPECT_LT(std::abs(turn[k]), 1e-14) << "rotation about axis " << k;
      EXPECT_GT(std::abs(moment[k]), 1e-3) << "moment about axis " << k;
    } else {
      EXPECT_GT(std::abs(turn[k]), 0.008) << "rotation about axis " << k;
      EXPECT_LT(std::abs(moment[k]), 1e-8) << "moment about axis " << k;
    }
  }
  const auto& points = result.shapes[0].points;
  std::size_t before = 0;
  while (points[before + 1].arc_length > points[before].arc_length) ++before;
  ASSERT_NEAR(points[before].arc_length, reaction.arc_length, 1e-12);
  const double jump = configurationalForce(points[before + 1]) - configurationalForce(points[before]);
  if (preset.slides) {
    EXPECT_GT(std::abs(reaction.arc_length - harness.clips[2].arc_length), 1e-4);
    // h is a sum of terms of tens of newtons, of a shape accurate to 1e-8 m
    EXPECT_LT(std::abs(jump), 1e-5 * std::abs(configurationalForce(points[before])));
  } else {
    EXPECT_EQ(reaction.arc_length, harness.clips[2].arc_length);
    if (preset.name != "free") {
      EXPECT_GT(std::abs(jump), 1e-2);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Table, ClipPreset, testing::ValuesIn(presets()),
                         [](const auto& of) { return of.param.name; });

TEST(FreeClip, AtTheEndLeavesACantilever) {
  const Cable cable = cableKinds()[1].cable;
  Harness harness = cantilever(cable);
  const Equilibrium without = solve(harness);
  harness.clips.push_back(clipOn(0, "tip", cable.length, freeClip(), poseAt(0.1, 0.2, 0.3)));
  const Equilibrium with = solve(harness);
  ASSERT_TRUE(with.converged()) << with.message;
  EXPECT_EQ(with.shapes[0].points.back().pose.position, without.shapes[0].points.back().pose.position);
  // m = ρA g L² / 2 for a light deflection, less what the sag takes off the lever
  const double weight = cable.sections[0].section.mass_per_length * 9.81;
  EXPECT_LT(with.clip_reactions[0].moment.norm(), 0.5 * weight * cable.length * cable.length);
  EXPECT_GT(with.clip_reactions[0].moment.norm(), 0.4 * weight * cable.length * cable.length);
}

}  // namespace
}  // namespace cable_variation::test
