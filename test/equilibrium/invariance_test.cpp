// What holds for every cable, clip and joint: a scene moved as a whole keeps its
// shape and energy, reactions balance what loads the harness, and a cable at
// rest has no energy.

#include <gtest/gtest.h>

#include <equilibrium/case_table.h>

namespace cable_variation::test {
namespace {

Harness movedAsAWhole(Harness harness, const Pose& motion) {
  const Eigen::Quaterniond& turn = motion.orientation;
  harness.gravity = turn * harness.gravity;
  for (Clip& clip : harness.clips) clip.pose = motion * clip.pose;
  for (PointLoad& load : harness.loads) {
    load.force = turn * load.force;
    load.moment = turn * load.moment;
  }
  for (Cable& cable : harness.cables) {
    for (Eigen::Vector3d& point : cable.via) point = motion * point;
  }
  return harness;
}

class EveryHarness : public testing::TestWithParam<NamedHarness> {};

TEST_P(EveryHarness, MovesWithItsScene) {
  const Pose motion{{0.7, -1.3, 0.4}, so3::exp({1.1, -0.8, 2.0})};
  const Equilibrium here = solve(GetParam().harness);
  const Equilibrium there = solve(movedAsAWhole(GetParam().harness, motion));
  ASSERT_TRUE(here.converged()) << here.message;
  ASSERT_TRUE(there.converged()) << there.message;
  // both are converged to far below their grids' accuracy; gravity's zero of energy has moved
  EXPECT_NEAR(there.energy.elastic, here.energy.elastic, 1e-9 * here.energy.elastic);
  EXPECT_NEAR(there.energy.springs, here.energy.springs, 1e-9 * (1.0 + here.energy.springs));
  for (std::size_t c = 0; c < here.shapes.size(); ++c) {
    const std::vector<Pose> before = here.shapes[c].sample(33);
    const std::vector<Pose> after = there.shapes[c].sample(33);
    for (std::size_t i = 0; i < before.size(); ++i) {
      EXPECT_LT((motion * before[i].position - after[i].position).norm(), 1e-8);
      EXPECT_LT(angleBetween(motion.orientation * before[i].orientation, after[i].orientation), 1e-7);
    }
  }
  for (std::size_t i = 0; i < here.clip_reactions.size(); ++i) {
    const Reaction& before = here.clip_reactions[i];
    const Reaction& after = there.clip_reactions[i];
    EXPECT_LT((motion.orientation * before.force - after.force).norm(), 1e-6 * (1.0 + before.force.norm()));
    EXPECT_LT((motion.orientation * before.moment - after.moment).norm(),
              1e-6 * (1.0 + before.moment.norm()));
  }
}

// The weight of a cable and its moment about the origin, by Simpson's rule on short pieces.
void addWeight(const Harness& harness, const CableShape& shape, const Cable& cable, Eigen::Vector3d& force,
               Eigen::Vector3d& moment) {
  const auto weightAt = [&](double s) -> Eigen::Vector3d {
    return sectionAt(cable, s).mass_per_length * harness.gravity;
  };
  std::vector<double> places{0.0, cable.length};
  for (const ShapePoint& point : shape.points) places.push_back(point.arc_length);
  for (const SectionAt& at : cable.sections) places.push_back(at.arc_length);
  std::sort(places.begin(), places.end());
  for (std::size_t i = 1; i < places.size(); ++i) {
    const double length = places[i] - places[i - 1];
    if (length < 1e-9) continue;
    constexpr int kPieces = 8;
    for (int k = 0; k < kPieces; ++k) {
      const double a = places[i - 1] + (k + 1e-9) * length / kPieces;
      const double b = places[i - 1] + (k + 1 - 1e-9) * length / kPieces;
      for (const auto& [s, share] : {std::pair(a, 1.0), std::pair(0.5 * (a + b), 4.0), std::pair(b, 1.0)}) {
        const Eigen::Vector3d weight = share / 6.0 * length / kPieces * weightAt(s);
        force += weight;
        moment += shape.position(s).cross(weight);
      }
    }
  }
}

// To 1e-8 N and N m; the shape's own accuracy of 1e-8 m leaves the weight's lever less than that.
TEST_P(EveryHarness, ReactionsBalanceWeightAndLoads) {
  const Harness& harness = GetParam().harness;
  const Equilibrium result = solve(harness, 1e-8);
  ASSERT_TRUE(result.converged()) << result.message;
  Eigen::Vector3d force = Eigen::Vector3d::Zero(), moment = force;
  for (std::size_t c = 0; c < harness.cables.size(); ++c) {
    addWeight(harness, result.shapes[c], harness.cables[c], force, moment);
  }
  ASSERT_GT(force.norm(), 0.05);  // there is a weight to balance
  for (const PointLoad& load : harness.loads) {
    force += load.force;
    moment += result.shapes[load.cable].position(load.arc_length).cross(load.force) + load.moment;
  }
  for (const Reaction& reaction : result.clip_reactions) {
    force += reaction.force;
    moment += reaction.section.position.cross(reaction.force) + reaction.moment;
  }
  EXPECT_LT(force.norm(), 1e-8);
  EXPECT_LT(moment.norm(), 1e-8);
}

INSTANTIATE_TEST_SUITE_P(Sections, EveryHarness, testing::ValuesIn(harnessPerSection()), harnessName);
INSTANTIATE_TEST_SUITE_P(Clips, EveryHarness, testing::ValuesIn(harnessPerClip()), harnessName);
INSTANTIATE_TEST_SUITE_P(Joints, EveryHarness, testing::ValuesIn(harnessPerJoint()), harnessName);

const Eigen::Vector3d kWeightless = Eigen::Vector3d::Zero();

class AtRest : public testing::TestWithParam<NamedHarness> {};

std::vector<NamedHarness> atRest() {
  std::vector<NamedHarness> table;
  for (const NamedCable& kind : cableKinds()) {
    if (kind.cable.rest_curvature.empty()) {
      table.push_back({kind.name, clamped(kind.cable, poseAt(kTableLength, 0.0, 0.0), kWeightless)});
    }
  }
  return table;
}

TEST_P(AtRest, StraightCableHasNoEnergy) {
  const Equilibrium result = solve(GetParam().harness);
  ASSERT_TRUE(result.converged()) << result.message;
  // strains of rounding, 1e-14, squared, times EA of 1e3 to 1e4 N
  EXPECT_LT(std::abs(result.energy.total()), 1e-20);
  for (const ShapePoint& point : result.shapes[0].points) {
    EXPECT_LT((point.pose.position - Eigen::Vector3d(point.arc_length, 0.0, 0.0)).norm(), 1e-12);
    EXPECT_LT(point.force.norm(), 1e-8);
  }
}

INSTANTIATE_TEST_SUITE_P(Sections, AtRest, testing::ValuesIn(atRest()), harnessName);

// A hose formed to a circular arc has its rest shape in closed form.
TEST(PreformedHose, HeldAtItsRestShapeHasNoEnergy) {
  const double radius = 0.12, angle = kTableLength / radius;
  Cable cable = uniformCable(kTableLength, hoseOfCaseH());
  cable.rest_curvature = {{0.0, {0.0, 0.0, 1.0 / radius}}};
  const Pose end = poseAt(radius * std::sin(angle), radius * (1.0 - std::cos(angle)), 0.0, {0.0, 0.0, angle});
  const Equilibrium result = solve(clamped(cable, end, kWeightless), 1e-8);
  ASSERT_TRUE(result.converged()) << result.message;
  const double straightened = 0.5 * hoseOfCaseH().EI_z / (radius * radius) * kTableLength;
  EXPECT_LT(result.energy.total(), 1e-10 * straightened);
  for (int i = 0; i <= 20; ++i) {
    const double turn = angle * i / 20.0;
    const Eigen::Vector3d arc(radius * std::sin(turn), radius * (1.0 - std::cos(turn)), 0.0);
    EXPECT_LT((result.shapes[0].position(radius * turn) - arc).norm(), 1e-8);
  }
}

// Any rest shape: free at one end it is taken up, and clamped there it stays.
TEST(PreformedHose, FreeOfLoadTakesItsRestShapeAndKeepsItWhenClamped) {
  const Cable cable = cableKinds().back().cable;
  const Equilibrium free = solve(cantilever(cable, kWeightless), 1e-8);
  ASSERT_TRUE(free.converged()) << free.message;
  const double straightened =
      solve(clamped(cable, poseAt(kTableLength, 0.0, 0.0), kWeightless)).energy.total();
  ASSERT_GT(straightened, 1e-3);
  EXPECT_LT(free.energy.total(), 1e-8 * straightened);
  const Equilibrium held = solve(clamped(cable, free.shapes[0].points.back().pose, kWeightless), 1e-8);
  ASSERT_TRUE(held.converged()) << held.message;
  EXPECT_LT(held.energy.total(), 1e-8 * straightened);
}

}  // namespace
}  // namespace cable_variation::test
