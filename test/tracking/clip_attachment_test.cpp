// Clips that open and close: the shape comes to rest from the one it had, and the harness without the clip is
// the oracle.
#include <cable_variation/tracking/clip_attachment.h>

#include <algorithm>
#include <stdexcept>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include <cable_variation/harness/topology.h>
#include <cable_variation/scene/design.h>
#include <cable_variation/scene_file/scene_reader.h>
#include <test_packages.h>

namespace cable_variation::test {
namespace {

constexpr double kAccuracy = 1e-5;  // [m]

Harness harnessOf(const std::string& file) {
  return readScene(std::string(CABLE_VARIATION_SOURCE_DIR) + "/" + file, findTestPackage).harness;
}

std::size_t clipNamed(const Harness& harness, const std::string& name) {
  for (std::size_t i = 0; i < harness.clips.size(); ++i) {
    if (harness.clips[i].name == name) return i;
  }
  throw std::invalid_argument(name);
}

Harness with(Harness harness, const std::string& clip, bool attached) {
  harness.clips[clipNamed(harness, clip)].attached = attached;
  return harness;
}

Harness without(Harness harness, const std::string& clip) {
  harness.clips.erase(harness.clips.begin() + static_cast<std::ptrdiff_t>(clipNamed(harness, clip)));
  return harness;
}

EquilibriumSolver solverToAccuracy() {
  EquilibriumOptions options;
  options.accuracy = kAccuracy;
  return EquilibriumSolver(options);
}

double largestDistance(const Equilibrium& a, const Equilibrium& b) {
  double largest = 0.0;
  for (std::size_t c = 0; c < a.shapes.size(); ++c) {
    const std::vector<Pose> on_a = a.shapes[c].sample(101), on_b = b.shapes[c].sample(101);
    for (std::size_t i = 0; i < on_a.size(); ++i)
      largest = std::max(largest, (on_a[i].position - on_b[i].position).norm());
  }
  return largest;
}

struct Case {
  const char* file;
  const char* clip;
};

class OpenedClip : public testing::TestWithParam<Case> {};

TEST_P(OpenedClip, LeavesTheHarnessAsIfItWereNotThere) {
  const Harness harness = harnessOf(GetParam().file);
  const Harness open = with(harness, GetParam().clip, false);
  EquilibriumSolver solver = solverToAccuracy(), oracle = solverToAccuracy();
  const Equilibrium found = solver.solve(open);
  const Equilibrium expected = oracle.solve(without(harness, GetParam().clip));
  ASSERT_TRUE(found.converged()) << found.message;
  ASSERT_TRUE(expected.converged()) << expected.message;
  EXPECT_EQ(largestDistance(found, expected), 0.0);  // the same numbers in the same order
  EXPECT_EQ(found.energy.total(), expected.energy.total());
  ASSERT_EQ(found.clip_reactions.size(), harness.clips.size());
  const Reaction& nothing = found.clip_reactions[clipNamed(harness, GetParam().clip)];
  EXPECT_EQ(nothing.name, GetParam().clip);
  EXPECT_EQ(nothing.force.norm() + nothing.moment.norm(), 0.0);
}

TEST_P(OpenedClip, LetsGoAndTakesHoldAgainInTheSameShape) {
  const Harness closed = harnessOf(GetParam().file);
  const Harness open = with(closed, GetParam().clip, false);
  EquilibriumSolver solver = solverToAccuracy();
  const Equilibrium before = solver.solve(closed);
  ASSERT_TRUE(before.converged()) << before.message;

  const AttachedClips released = followAttachment(solver, closed, before, open);
  const Equilibrium& loose = released.followed.equilibrium;
  ASSERT_TRUE(loose.converged()) << loose.message;
  EXPECT_LT(loose.energy.total(), before.energy.total());
  EXPECT_NEAR(released.energy_released, before.energy.total() - loose.energy.total(),
              1e-6 * before.energy.total());
  EXPECT_NEAR(released.distance, largestDistance(before, loose), 1e-9);
  EquilibriumSolver rested = solver;  // it is an equilibrium of the harness without the clip
  const Equilibrium again = rested.update(open);
  ASSERT_TRUE(again.converged());
  EXPECT_LT(largestDistance(again, loose), 2.0 * kAccuracy);

  const AttachedClips taken = followAttachment(solver, open, loose, closed);
  const Equilibrium& after = taken.followed.equilibrium;
  ASSERT_TRUE(after.converged()) << after.message;
  if (!taken.followed.jump) {
    EXPECT_LT(largestDistance(after, before), 2.0 * kAccuracy);
    EXPECT_NEAR(after.energy.total(), before.energy.total(), 1e-5 * std::abs(before.energy.total()));
  } else {
    EXPECT_GT(taken.followed.jump->distance, 0.003);
  }
}

INSTANTIATE_TEST_SUITE_P(Cases, OpenedClip,
                         testing::Values(Case{"test/ros/data/measured.yaml", "B"},
                                         Case{"config/harness.yaml", "WH_Start"},
                                         Case{"config/harness.yaml", "WH_Branch"},
                                         Case{"config/harness_clipped.yaml", "WH_Tie"}),
                         [](const auto& case_info) {
                           std::string name = case_info.param.clip;
                           return name + std::to_string(case_info.index);
                         });

TEST(ClipAttachment, AConnectorIsHandedOverWithoutMoving) {
  Harness held = harnessOf("test/ros/data/measured.yaml");
  Clip other = held.clips[1];
  other.name = "C";
  other.attached = false;
  held.clips.push_back(other);
  Harness handed = held;
  handed.clips[1].attached = false;
  handed.clips[2].attached = true;
  EquilibriumSolver solver = solverToAccuracy();
  const Equilibrium before = solver.solve(held);
  const AttachedClips attached = followAttachment(solver, held, before, handed);
  ASSERT_TRUE(attached.followed.equilibrium.converged());
  EXPECT_LT(attached.distance, 2.0 * kAccuracy);
  EXPECT_FALSE(attached.followed.jump);
  EXPECT_NEAR(attached.followed.equilibrium.clip_reactions[2].force.norm(),
              before.clip_reactions[1].force.norm(), 1e-4);
  handed.clips[1].attached = true;  // both hold one section
  EXPECT_THROW(followAttachment(solver, held, before, handed), std::invalid_argument);
}

TEST(ClipAttachment, AnEyeletTakesTheNearestSectionAndSlidesOn) {
  const Harness plain = harnessOf("test/ros/data/measured.yaml");
  EquilibriumSolver solver = solverToAccuracy();
  Harness open = plain;
  Clip eyelet;
  eyelet.name = "eyelet";
  eyelet.type = "eyelet";
  eyelet.constraint = eyeletClip();
  eyelet.arc_length = 0.1;
  eyelet.attached = false;
  const Equilibrium before = solver.solve(plain);
  eyelet.pose = before.shapes[0].pose(0.17);
  eyelet.pose.position.z() += 0.004;
  open.clips.push_back(eyelet);
  const Equilibrium with_open = solver.solve(open);
  const AttachmentGap gap = closestSection(eyelet, with_open.shapes[0], 0.01);
  EXPECT_NEAR(gap.arc_length, 0.17, 0.004);
  EXPECT_GT(gap.distance, 0.001);
  EXPECT_LE(gap.distance, 0.004);
  Harness closed = open;
  closed.clips.back().attached = true;
  closed.clips.back().arc_length = gap.arc_length;
  const AttachedClips attached = followAttachment(solver, open, with_open, closed);
  const Equilibrium& after = attached.followed.equilibrium;
  ASSERT_TRUE(after.converged()) << after.message;
  const Reaction& reaction = after.clip_reactions.back();
  EXPECT_LT((after.shapes[0].position(reaction.arc_length) - eyelet.pose.position).norm(), 1e-6);
  EXPECT_GT(reaction.force.norm(), 1e-3);
}

TEST(ClipAttachment, TheLastClipOfACableStays) {
  Scene scene;
  scene.harness = harnessOf("test/ros/data/measured.yaml");
  Design design{scene, {}};
  setAttached(design, "A", false);
  EXPECT_FALSE(design.scene.harness.clips[0].attached);
  try {
    setAttached(design, "B", false);
    FAIL();
  } catch (const std::invalid_argument& error) {
    EXPECT_NE(std::string(error.what()).find("cable 'strand' is held by no attached clip"), std::string::npos)
        << error.what();
  }
  EXPECT_TRUE(design.scene.harness.clips[1].attached);
  EXPECT_THROW(setAttached(design, "Z", true), std::invalid_argument);
}

TEST(SolveFrom, ShapesOfOtherCablesAreRefused) {
  const Harness harness = harnessOf("test/ros/data/measured.yaml");
  EquilibriumSolver solver;
  std::vector<CableShape> shapes = solver.solve(harness).shapes;
  EXPECT_TRUE(solver.solveFrom(harness, shapes).converged());
  shapes[0].cable = "other";
  EXPECT_THROW(solver.solveFrom(harness, shapes), std::invalid_argument);
  EXPECT_THROW(solver.solveFrom(harness, {}), std::invalid_argument);
}

}  // namespace
}  // namespace cable_variation::test
