// update() follows a shape to where solve() would find it, when the harness changes in numbers.

#include <functional>
#include <random>

#include <gtest/gtest.h>

#include <equilibrium/case_table.h>

namespace cable_variation::test {
namespace {

constexpr double kAccuracy = 1e-5;

EquilibriumSolver solverAt(double accuracy) {
  EquilibriumOptions options;
  options.accuracy = accuracy;
  return EquilibriumSolver(options);
}

double largestDistanceBetween(const Equilibrium& a, const Equilibrium& b) {
  double largest = 0.0;
  for (std::size_t c = 0; c < a.shapes.size(); ++c) {
    const std::vector<Pose> on_a = a.shapes[c].sample(41);
    const std::vector<Pose> on_b = b.shapes[c].sample(41);
    for (std::size_t i = 0; i < on_a.size(); ++i) {
      largest = std::max(largest, (on_a[i].position - on_b[i].position).norm());
    }
  }
  return largest;
}

struct Change {
  const char* name;
  std::function<void(Harness&)> apply;
};

std::ostream& operator<<(std::ostream& out, const Change& change) { return out << change.name; }

std::vector<Change> changes() {
  return {
      {"nothing", [](Harness&) {}},
      {"clip_moved", [](Harness& h) { h.clips[1].pose.position += Eigen::Vector3d(0.004, -0.005, 0.003); }},
      {"clip_turned",
       [](Harness& h) {
         h.clips[1].pose.orientation = h.clips[1].pose.orientation * so3::exp({0.05, 0.08, -0.06});
       }},
      {"clip_turned_far",
       [](Harness& h) {
         h.clips[1].pose.orientation = h.clips[1].pose.orientation * so3::exp({0.0, 0.9, 0.0});
       }},
      {"middle_clip_moved",
       [](Harness& h) {
         h.clips[2].pose = h.clips[2].pose * poseAt(0.01, 0.0, 0.01, {0.2, 0, 0});
       }},
      {"clip_arc_length", [](Harness& h) { h.clips[2].arc_length += 0.004; }},
      {"length",
       [](Harness& h) {
         h.cables[0].length += 0.006;
         h.clips[1].arc_length += 0.006;
       }},
      {"stiffness",
       [](Harness& h) {
         h.cables[0].sections[0].section.EI_y *= 1.4;
         h.cables[0].sections[0].section.EI_z *= 1.4;
       }},
      {"weight", [](Harness& h) { h.cables[0].sections[0].section.mass_per_length *= 3.0; }},
      {"gravity",
       [](Harness& h) {
         h.gravity = {0.0, 9.81, 0.0};
       }},
      {"load", [](Harness& h) { h.loads[0].force *= -1.0; }}};
}

using ClipAndChange = std::tuple<std::string, Change>;

class Update : public testing::TestWithParam<ClipAndChange> {};

TEST_P(Update, AgreesWithSolve) {
  const auto& [clip, change] = GetParam();
  const auto presets = clipPresets();
  const auto preset = std::find_if(presets.begin(), presets.end(),
                                   [&name = clip](const NamedClip& of) { return of.name == name; });
  ASSERT_NE(preset, presets.end());
  Harness harness = heldBetween(cableKinds()[1].cable, preset->constraint);
  EquilibriumSolver follower = solverAt(kAccuracy);
  const Equilibrium before = follower.solve(harness);
  ASSERT_TRUE(before.converged()) << before.message;
  change.apply(harness);
  const Equilibrium followed = follower.update(harness);
  const Equilibrium cold = solverAt(kAccuracy).solve(harness);
  ASSERT_TRUE(followed.converged()) << followed.message;
  ASSERT_TRUE(cold.converged()) << cold.message;
  // each is within the accuracy of the continuum
  EXPECT_LT(largestDistanceBetween(followed, cold), 2.0 * kAccuracy);
  EXPECT_NEAR(followed.energy.total(), cold.energy.total(), 1e-4 * std::abs(cold.energy.total()));
  // where a sliding clip starts its search is no part of the equilibrium
  const bool idle = std::string(change.name) == "nothing" ||
                    (std::string(change.name) == "clip_arc_length" && preset->constraint.slides);
  if (!idle) {
    EXPECT_GT(largestDistanceBetween(before, cold), 2e-5);
  }
}

INSTANTIATE_TEST_SUITE_P(Changes, Update,
                         testing::Combine(testing::Values("fixed", "sliding_rolling", "grommet"),
                                          testing::ValuesIn(changes())),
                         [](const auto& of) {
                           return std::get<0>(of.param) + "_" + std::get<1>(of.param).name;
                         });

// Away and back again ends where it began.
TEST(UpdateRoundTrip, ReturnsToItsShape) {
  const Harness home = caseH();
  EquilibriumSolver solver = solverAt(kAccuracy);
  const Equilibrium first = solver.solve(home);
  for (int step = 1; step <= 8; ++step) {
    Harness away = home;
    away.clips[1].pose =
        away.clips[1].pose * poseAt(0.003 * step, 0.0, -0.002 * step, {0.0, 0.04 * step, 0.0});
    ASSERT_TRUE(solver.update(away).converged()) << "step " << step;
  }
  const Equilibrium back = solver.update(home);
  ASSERT_TRUE(back.converged()) << back.message;
  EXPECT_LT(largestDistanceBetween(first, back), 2.0 * kAccuracy);
}

std::size_t sectionsOf(const Equilibrium& equilibrium) {
  std::size_t count = 0;
  for (const CableShape& shape : equilibrium.shapes) count += shape.points.size();
  return count;
}

// A pose on the way may need a fine grid; those after it are not slower for that, and no less right.
TEST(UpdateThroughAHardPose, LeavesTheFineGridAgain) {
  std::mt19937 random(8);
  std::uniform_real_distribution<double> share(-1.0, 1.0);
  int grown = 0, compared = 0;
  for (const Harness& home : {caseH(), caseW()}) {
    EquilibriumSolver alone = solverAt(kAccuracy);
    const std::size_t first = sectionsOf(alone.solve(home));
    for (int round = 0; round < 20; ++round) {
      EquilibriumSolver solver = solverAt(kAccuracy);
      solver.solve(home);
      Harness hard = home;
      Pose& pose = hard.clips[1].pose;
      pose = pose * poseAt(0.06 * share(random), 0.06 * share(random), 0.06 * share(random),
                           {2.0 * share(random), 2.0 * share(random), 2.0 * share(random)});
      const Equilibrium there = solver.update(hard);
      if (!there.converged() || sectionsOf(there) <= first) continue;
      ++grown;
      for (int i = 0; i < 8; ++i) {
        Harness near = home;
        near.clips[1].pose.position += 5e-4 * Eigen::Vector3d(share(random), share(random), share(random));
        const Equilibrium back = solver.update(near), right = alone.update(near);
        ASSERT_TRUE(back.converged() && right.converged());
        if (i == 7) {
          EXPECT_LE(sectionsOf(back), first);
        }
        const double distance = largestDistanceBetween(back, right);
        if (distance > 0.01) continue;  // it went over to another branch on the way there
        ++compared;
        EXPECT_LT(distance, 2.0 * kAccuracy);
      }
    }
  }
  EXPECT_GE(grown, 5);
  EXPECT_GE(compared, 5 * grown);
}

// It keeps to its own shape although another has less energy: a slack strip, stiff sideways, that bows up.
TEST(UpdateFollows, TheShapeItHasNotTheLowest) {
  Cable cable = uniformCable(0.312, strandOfCaseW(), "strip");
  cable.sections[0].section.EI_z *= 10.0;
  cable.via = {{0.11, 0.0, 0.09}};
  Harness harness = clamped(cable, poseAt(0.22, 0.0, 0.0));
  EquilibriumSolver solver = solverAt(kAccuracy);
  const Equilibrium hinted = solver.solve(harness);
  ASSERT_TRUE(hinted.converged()) << hinted.message;
  ASSERT_GT(hinted.shapes[0].position(0.156).z(), 0.02);
  harness.cables[0].via.clear();
  harness.clips[1].pose.position.x() += 0.003;
  EXPECT_GT(solver.update(harness).shapes.at(0).position(0.156).z(), 0.02);
  EXPECT_LT(solverAt(kAccuracy).solve(harness).shapes.at(0).position(0.156).z(), -0.02);
}

TEST(UpdateWithAnotherStructure, SolvesAnew) {
  EquilibriumSolver solver = solverAt(kAccuracy);
  ASSERT_TRUE(solver.solve(caseH()).converged());
  const Equilibrium other = solver.update(branched(Joint::Type::fixed));
  ASSERT_TRUE(other.converged()) << other.message;
  EXPECT_EQ(other.shapes.size(), 2u);
}

TEST(UpdateAfterACopy, LeavesTheOriginalAlone) {
  const Harness home = caseH();
  Harness away = home;
  away.clips[1].pose.position.z() += 0.01;
  EquilibriumSolver original = solverAt(kAccuracy);
  original.solve(home);
  EquilibriumSolver copy = original;
  const Equilibrium moved = copy.update(away);
  const Equilibrium stayed = original.update(home);
  ASSERT_TRUE(moved.converged() && stayed.converged());
  EXPECT_NEAR(
      moved.shapes[0].points.back().pose.position.z() - stayed.shapes[0].points.back().pose.position.z(),
      0.01, 1e-12);
}

}  // namespace
}  // namespace cable_variation::test
