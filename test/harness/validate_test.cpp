// What a harness must be, and what is said of one that is not.

#include <functional>
#include <limits>
#include <stdexcept>

#include <gtest/gtest.h>

#include <equilibrium/case_table.h>

namespace cable_variation::test {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

struct Broken {
  const char* name;
  std::function<void(Harness&)> breakIt;
  const char* message;  ///< all of it
};

std::ostream& operator<<(std::ostream& out, const Broken& broken) { return out << broken.name; }

// Of a sound harness: "cable" of 0.3 m with clips A, B, C and a load, "branch" of 0.12 m, joint "breakout".
std::vector<Broken> table() {
  return {{"no_cable", [](Harness& h) { h = Harness{}; }, "the harness has no cable, expected at least one"},
          {"gravity", [](Harness& h) { h.gravity.x() = kNan; }, "gravity is not finite"},
          {"zero_length", [](Harness& h) { h.cables[1].length = 0.0; },
           "cable 'branch': length is 0 m, expected a positive number"},
          {"nan_length", [](Harness& h) { h.cables[1].length = kNan; },
           "cable 'branch': length is nan m, expected a positive number"},
          {"no_section", [](Harness& h) { h.cables[1].sections.clear(); },
           "cable 'branch': has no section, expected at least one"},
          {"section_beyond_the_end",
           [](Harness& h) {
             h.cables[1].sections.push_back({0.2, h.cables[1].sections[0].section});
           },
           "cable 'branch': section 1 is at 0.2 m, expected between 0 and the length of 0.12 m"},
          {"sections_out_of_order",
           [](Harness& h) {
             const Section section = h.cables[1].sections[0].section;
             h.cables[1].sections = {{0.0, section}, {0.1, section}, {0.05, section}};
           },
           "cable 'branch': section 2 is at 0.05 m, expected not before the previous one at 0.1 m"},
          {"rest_curvature_before_the_start",
           [](Harness& h) {
             h.cables[0].rest_curvature = {{-0.1, {0, 0, 1}}};
           },
           "cable 'cable': rest curvature 0 is at -0.1 m, expected between 0 and the length of 0.3 m"},
          {"rest_curvature_not_finite",
           [](Harness& h) {
             h.cables[0].rest_curvature = {{0.1, {0, 0, kNan}}};
           },
           "cable 'cable': rest curvature 0 is not finite"},
          {"negative_stiffness", [](Harness& h) { h.cables[0].sections[0].section.EI_y = -2.0; },
           "cable 'cable': EI_y is -2, expected a positive number"},
          {"zero_stiffness", [](Harness& h) { h.cables[0].sections[0].section.GJ = 0.0; },
           "cable 'cable': GJ is 0, expected a positive number"},
          {"negative_mass", [](Harness& h) { h.cables[0].sections[0].section.mass_per_length = -1.0; },
           "cable 'cable': mass_per_length is -1, expected zero or more"},
          {"thicker_than_long", [](Harness& h) { h.cables[1].sections[0].section.radius = 0.2; },
           "cable 'branch': radius is 0.2 m, expected less than the length of 0.12 m"},
          {"via",
           [](Harness& h) {
             h.cables[0].via = {{0, kNan, 0}};
           },
           "cable 'cable': via point 0 is not finite"},
          {"twist", [](Harness& h) { h.cables[0].twist = kNan; }, "cable 'cable': twist is not finite"},
          {"clip_of_no_cable", [](Harness& h) { h.clips[2].cable = 7; },
           "clip 'C' names cable 7, expected less than the 2 cables there are"},
          {"clip_beyond_the_end", [](Harness& h) { h.clips[2].arc_length = 0.4; },
           "clip 'C' is at 0.4 m of cable 'cable', expected between 0 and its length of 0.3 m"},
          {"clip_before_the_start", [](Harness& h) { h.clips[2].arc_length = -0.01; },
           "clip 'C' is at -0.01 m of cable 'cable', expected between 0 and its length of 0.3 m"},
          {"clip_orientation", [](Harness& h) { h.clips[2].pose.orientation.coeffs() *= 2.0; },
           "clip 'C' has an orientation of norm 2, expected 1"},
          {"clip_position", [](Harness& h) { h.clips[2].pose.position.y() = kNan; },
           "clip 'C' has a position that is not finite"},
          {"sliding_clip_at_an_end", [](Harness& h) { h.clips[0].constraint = slidingClip(); },
           "clip 'A' slides, so it must start inside cable 'cable', between 0 and 0.3 m; it is at 0 m"},
          {"clip_spring",
           [](Harness& h) {
             h.clips[2].constraint = grommetClip({1.0, 1.0, -3.0, 1.0});
           },
           "clip 'C' has a spring of stiffness -3, expected a positive number"},
          {"two_clips_at_one_place", [](Harness& h) { h.clips[2].arc_length = 0.3; },
           "clip 'B' and clip 'C' both hold cable 'cable' at 0.3 m, expected different places"},
          {"clip_on_a_joined_end", [](Harness& h) { h.clips.push_back(clipOn(1, "D", 0.0, fixedClip())); },
           "clip 'D' and joint 'breakout' both hold cable 'branch' at 0 m, expected different places"},
          {"joint_of_no_cable", [](Harness& h) { h.joints[0].child = 5; },
           "joint 'breakout' names cable 5, expected less than the 2 cables there are"},
          {"joint_beyond_the_end", [](Harness& h) { h.joints[0].parent_arc_length = 0.31; },
           "joint 'breakout' is at 0.31 m of cable 'cable', expected between 0 and its length of 0.3 m"},
          {"joint_rotation", [](Harness& h) { h.joints[0].rotation.coeffs() *= 0.5; },
           "joint 'breakout' has an orientation of norm 0.5, expected 1"},
          {"hinge_axis",
           [](Harness& h) {
             h.joints[0].type = Joint::Type::hinge;
             h.joints[0].axis = {0.0, 0.0, 2.0};
           },
           "joint 'breakout' has a hinge axis of length 2, expected 1"},
          {"joint_to_itself", [](Harness& h) { h.joints[0].child = 0; },
           "joint 'breakout' joins cable 'cable' to itself, expected two cables"},
          {"joints_in_a_circle",
           [](Harness& h) {
             h.joints[0].parent_arc_length = 0.3;
             h.clips.erase(h.clips.begin() + 1);
             Joint back = h.joints[0];
             back.name = "back";
             std::swap(back.parent, back.child);
             std::swap(back.parent_arc_length, back.child_arc_length);
             h.joints.push_back(back);
           },
           "joint 'breakout' hangs on itself: its parent's section is, through other joints, its own child"},
          {"cable_that_nothing_holds", [](Harness& h) { h.joints.clear(); },
           "cable 'branch' is held by no clip, neither itself nor through a joint; expected at least one"},
          {"held_by_a_free_clip_only",
           [](Harness& h) {
             for (Clip& clip : h.clips) clip.constraint = freeClip();
           },
           "cable 'cable' is held by no clip, neither itself nor through a joint; expected at least one"},
          {"load_beyond_the_end", [](Harness& h) { h.loads[0].arc_length = 1.0; },
           "load 'load' is at 1 m of cable 'cable', expected between 0 and its length of 0.3 m"},
          {"load_force", [](Harness& h) { h.loads[0].force.x() = kNan; },
           "load 'load' has a force that is not finite"},
          {"load_moment", [](Harness& h) { h.loads[0].moment.x() = kNan; },
           "load 'load' has a moment that is not finite"}};
}

class BrokenHarness : public testing::TestWithParam<Broken> {};

TEST_P(BrokenHarness, IsRefusedWithItsMessage) {
  Harness harness = branched(Joint::Type::fixed);
  ASSERT_TRUE(faultsOf(harness).empty()) << faultsOf(harness).front();
  GetParam().breakIt(harness);
  const std::vector<std::string> faults = faultsOf(harness);
  ASSERT_FALSE(faults.empty());
  EXPECT_EQ(faults.front(), GetParam().message);
  try {
    EquilibriumSolver().solve(harness);
    FAIL() << "solve() took it";
  } catch (const std::invalid_argument& error) {
    EXPECT_STREQ(error.what(), GetParam().message);
  }
}

INSTANTIATE_TEST_SUITE_P(Table, BrokenHarness, testing::ValuesIn(table()),
                         [](const auto& of) { return of.param.name; });

TEST(BrokenHarness, TellsAllItsFaults) {
  Harness harness = branched(Joint::Type::fixed);
  harness.clips[0].arc_length = -1.0;
  harness.clips[2].arc_length = 2.0;
  harness.cables[1].length = -3.0;
  EXPECT_EQ(faultsOf(harness).size(), 5u);  // and the joint and the load that lie beyond that length
}

TEST(SlidingClip, MustStartWhereNothingElseIs) {
  Harness harness = heldBetween(cableKinds()[1].cable, slidingClip());
  harness.loads[0].arc_length = harness.clips[2].arc_length;
  try {
    EquilibriumSolver().solve(harness);
    FAIL() << "solve() took it";
  } catch (const std::invalid_argument& error) {
    EXPECT_STREQ(error.what(),
                 "clip 'C' slides and starts at 0.141 m of cable 'cable', where something else is; "
                 "expected a place of its own");
  }
}

}  // namespace
}  // namespace cable_variation::test
