#pragma once

// One harness per kind of section, clip preset and joint: small, without symmetry, everything loaded.

#include <string>
#include <vector>

#include <gtest/gtest.h>

#include <equilibrium/cases.h>

namespace cable_variation::test {

struct NamedHarness {
  std::string name;
  Harness harness;
};

inline std::ostream& operator<<(std::ostream& out, const NamedHarness& of) { return out << of.name; }

inline std::string harnessName(const testing::TestParamInfo<NamedHarness>& of) { return of.param.name; }

struct NamedCable {
  std::string name;
  Cable cable;
};

constexpr double kTableLength = 0.3;

inline std::vector<NamedCable> cableKinds() {
  const Material rubber{6e6, 0.45, 1200.0};
  std::vector<NamedCable> kinds;
  kinds.push_back({"solid", uniformCable(kTableLength, solidSection(0.004, {1e8, 0.25, 2000.0}))});
  kinds.push_back({"hose", uniformCable(kTableLength, hoseSection(0.012, 0.009, rubber, 0.6))});
  kinds.push_back({"rectangle", uniformCable(kTableLength, rectangleSection(0.012, 0.006, rubber))});
  Cable varying = uniformCable(kTableLength, solidSection(0.010, rubber));
  varying.sections.push_back({0.12, solidSection(0.012, rubber)});
  varying.sections.push_back({0.12, hoseSection(0.013, 0.009, rubber)});
  varying.sections.push_back({kTableLength, hoseSection(0.010, 0.006, rubber)});
  kinds.push_back({"varying", varying});
  Cable formed = uniformCable(kTableLength, hoseSection(0.012, 0.009, rubber));
  formed.rest_curvature = {{0.0, {0.5, 1.0, -2.0}},
                           {0.1, {-1.0, 3.0, 0.0}},
                           {0.2, {0.0, 4.0, 5.0}},
                           {kTableLength, {2.0, 0.0, 3.0}}};
  kinds.push_back({"preformed", formed});
  return kinds;
}

struct NamedClip {
  std::string name;
  ClipConstraint constraint;
};

inline std::vector<NamedClip> clipPresets() {
  const GrommetStiffness rubber{300.0, 500.0, 0.1, 0.2};
  return {{"fixed", fixedClip()},
          {"rolling", rollingClip()},
          {"pivot", pivotClip()},
          {"hinge_x", hingeClip(Axis::x)},
          {"hinge_y", hingeClip(Axis::y)},
          {"hinge_z", hingeClip(Axis::z)},
          {"sliding", slidingClip()},
          {"sliding_rolling", slidingRollingClip()},
          {"eyelet", eyeletClip()},
          {"guide", guideClip()},
          {"guide_rolling", guideClip(true)},
          {"plane_x", planeClip(Axis::x)},
          {"plane_y", planeClip(Axis::y)},
          {"plane_z", planeClip(Axis::z)},
          {"grommet", grommetClip(rubber)},
          {"grommet_sliding", grommetClip(rubber, true)},
          {"free", freeClip()}};
}

/// Clamped at both ends with slack, the clip in question between, forces on the free length.
inline Harness heldBetween(const Cable& cable, const ClipConstraint& constraint) {
  const double length = cable.length;
  Harness harness = clamped(cable, poseAt(0.82 * length, 0.25 * length, -0.1 * length, {0.3, -0.2, 0.9}));
  harness.clips.push_back(clipOn(0, "C", 0.47 * length, constraint,
                                 poseAt(0.44 * length, 0.06 * length, 0.07 * length, {0.2, -0.3, 0.4})));
  harness.loads = {loadAt(0, 0.8 * length, {0.3, -0.8, 0.5})};
  return harness;
}

inline std::vector<NamedHarness> harnessPerSection() {
  std::vector<NamedHarness> table;
  for (const NamedCable& kind : cableKinds()) {
    table.push_back({kind.name + "_fixed", heldBetween(kind.cable, fixedClip())});
    table.push_back({kind.name + "_sliding", heldBetween(kind.cable, slidingRollingClip())});
    Harness hanging = cantilever(kind.cable);
    hanging.loads = {loadAt(0, kTableLength, {0.2, 0.1, -0.3}, {0.004, 0.003, -0.002})};
    table.push_back({kind.name + "_cantilever", hanging});
  }
  return table;
}

inline std::vector<NamedHarness> harnessPerClip() {
  std::vector<NamedHarness> table;
  for (const NamedClip& preset : clipPresets()) {
    table.push_back({preset.name, heldBetween(cableKinds()[1].cable, preset.constraint)});
  }
  return table;
}

/// A clamped trunk with a branch that hangs on it and is loaded at its end.
inline Harness branched(Joint::Type type) {
  Harness harness = heldBetween(cableKinds()[1].cable, rollingClip());
  // neither round nor straight: a round branch would be free to roll in a pivot, a straight one to turn over
  harness.cables.push_back(uniformCable(0.12, rectangleSection(0.012, 0.006, {6e6, 0.45, 1200.0}), "branch"));
  harness.cables[1].rest_curvature = {{0.0, {1.0, 4.0, 2.0}}};
  Joint joint;
  joint.name = "breakout";
  joint.type = type;
  joint.parent_arc_length = 0.21;
  joint.child = 1;
  joint.rotation = so3::exp({0.2, 0.1, 0.9});
  joint.axis = Eigen::Vector3d(0.2, -0.3, 0.8).normalized();
  harness.joints = {joint};
  harness.loads.push_back(loadAt(1, 0.12, {0.4, 0.3, -0.2}));
  return harness;
}

/// A second cable whose both ends hang on the first.
inline Harness closedLoop() {
  Harness harness = branched(Joint::Type::hinge);
  harness.loads.clear();
  Joint back = harness.joints[0];
  back.name = "return";
  back.type = Joint::Type::fixed;
  back.parent_arc_length = 0.09;
  back.child_arc_length = 0.12;
  back.rotation = so3::exp({0.0, 0.2, 1.9});
  harness.joints[0].axis = {0.0, 0.0, 1.0};
  harness.joints.push_back(back);
  harness.cables[1].length = back.child_arc_length = 0.2;
  return harness;
}

inline std::vector<NamedHarness> harnessPerJoint() {
  return {{"joint_fixed", branched(Joint::Type::fixed)},
          {"joint_pivot", branched(Joint::Type::pivot)},
          {"joint_hinge", branched(Joint::Type::hinge)},
          {"closed_loop", closedLoop()}};
}

}  // namespace cable_variation::test
