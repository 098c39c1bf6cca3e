// Which shape is answered: the lowest of those that simple starts lead to, with the twist that was asked for,
// and never a saddle.

#include <gtest/gtest.h>

#include <equilibrium/cases.h>

namespace cable_variation::test {
namespace {

const Eigen::Vector3d kWeightless = Eigen::Vector3d::Zero();

// Where a sliding clip is said to start is a hint where to look, no more.
TEST(SlidingClip, ItsStartDoesNotDecide) {
  const auto pose = [](const Eigen::Vector3d& position, double w, double x, double y, double z) {
    return Pose{position, Eigen::Quaterniond(w, x, y, z).normalized()};
  };
  for (const double start : {0.05, 0.15, 0.25, 0.343, 0.35, 0.39}) {
    Harness harness;
    harness.gravity.setZero();
    harness.cables = {uniformCable(0.491, roundSection(18000.0, 6940.0, 0.00399, 0.00518, 0.0162))};
    harness.clips = {
        clipOn(0, "slide", start, slidingClip()),
        clipOn(0, "B", 0.407, fixedClip(), pose({0.042, -0.018, 0.003}, 0.9491, -0.0210, -0.1590, -0.2710)),
        clipOn(0, "C", 0.491, fixedClip(), pose({0.080, -0.063, 0.015}, 0.8062, -0.0920, -0.1971, -0.5502))};
    const Equilibrium result = solve(harness);
    ASSERT_TRUE(result.converged()) << start << ": " << result.message;
    EXPECT_NEAR(result.energy.total(), 0.530, 0.002) << start;
  }
}

TEST(PreformedCable, FreeOfLoadsTakesItsForm) {
  for (const double turns_per_metre : {1.0, 3.0, 6.0}) {
    for (const double length : {0.4, 1.2, 1.6, 2.5}) {
      Cable cable = uniformCable(length, roundSection(5e3, 2e3, 0.016, 0.02, 0.1, 2e-3));
      cable.rest_curvature = {{0.0, {1.27, 0.0, 2.0 * M_PI * turns_per_metre}}};
      const Equilibrium result = solve(cantilever(cable, kWeightless));
      ASSERT_TRUE(result.converged()) << length << " m: " << result.message;
      EXPECT_LT(result.energy.total(), 1e-12) << length << " m, " << turns_per_metre << " turns/m";
    }
  }
}

// Held by both ends in the pose it has by itself.
TEST(PreformedCable, BetweenClampsThatFitItTakesItsForm) {
  Cable cable = uniformCable(0.8, roundSection(5e3, 2e3, 0.016, 0.02, 0.1, 2e-3));
  cable.rest_curvature = {{0.0, {0.5, 2.0, 9.0}}, {0.8, {0.0, -3.0, 6.0}}};
  const Equilibrium alone = solve(cantilever(cable, kWeightless), 1e-6);
  ASSERT_TRUE(alone.converged()) << alone.message;
  const Equilibrium held = solve(clamped(cable, alone.shapes[0].points.back().pose, kWeightless));
  ASSERT_TRUE(held.converged()) << held.message;
  EXPECT_LT(held.energy.total(), 1e-6);
}

double twistOf(const CableShape& shape) {
  double sum = 0.0;
  for (std::size_t i = 1; i < shape.points.size(); ++i) {
    const ShapePoint &a = shape.points[i - 1], &b = shape.points[i];
    sum += 0.5 * (b.arc_length - a.arc_length) * (a.curvature.x() + b.curvature.x());
  }
  return sum;
}

// Drawn tight, any number of turns is wound in: GJ θ/L.
TEST(GivenTwist, OfAnyNumberOfTurnsIsKept) {
  for (const double turns : {1.0, 5.0, 8.0, 9.0, 10.0, -13.0, 16.0}) {
    Cable cable = uniformCable(1.0, roundSection(1e6, 4e5, 0.6, 1.0));
    cable.twist = 2.0 * M_PI * turns;
    const Equilibrium result = solve(clamped(cable, poseAt(1.001, 0.0, 0.0), kWeightless));
    ASSERT_TRUE(result.converged()) << turns << ": " << result.message;
    EXPECT_NEAR(result.clip_reactions[1].moment.x(), 0.6 * *cable.twist, 1e-3 * 0.6 * std::abs(*cable.twist));
  }
}

// Slack, a cable may wind about itself instead: then the answer says so.
TEST(GivenTwist, ThatBecameWritheIsNoted) {
  for (const double turns : {2.0, 4.0, 6.0}) {
    Cable cable = uniformCable(0.5, roundSection(1e4, 4e3, 0.016, 0.02, 0.1));
    cable.twist = 2.0 * M_PI * turns;
    const Equilibrium result = solve(clamped(cable, poseAt(0.3, 0.0, 0.0)));
    if (!result.converged()) continue;
    const bool kept = std::abs(twistOf(result.shapes[0]) - *cable.twist) < 1.5 * M_PI;
    EXPECT_TRUE(kept || !result.notes.empty()) << turns << " turns, " << twistOf(result.shapes[0]) << " rad";
  }
}

// Long soft cables, w L³/EI up to 1.6e5, hang without a turn that nobody asked for: it would cost ½ GJ
// (2π)²/L.
TEST(LongSoftCable, KeepsNoTurn) {
  for (const double length : {1.0, 1.5, 2.0}) {
    for (const double EI : {1e-4, 3e-4, 1e-3}) {
      for (const double share : {0.5, 0.8, 0.95}) {
        Cable cable = uniformCable(length, roundSection(5e3, 2e3, 0.8 * EI, EI, 0.2, 3e-3));
        for (const bool hinted : {false, true}) {
          SCOPED_TRACE(testing::Message() << length << " m, " << EI << " N m², " << share << ", " << hinted);
          if (hinted) cable.twist = 0.0;
          const Equilibrium result = solve(clamped(cable, poseAt(share * length, 0.0, 0.0)));
          ASSERT_TRUE(result.converged()) << result.message;
          EXPECT_NEAR(twistOf(result.shapes[0]), 0.0, 0.05);
        }
      }
    }
  }
}

// A spring's energy grows with the angle up to half a turn, not beyond: none is wound up further.
TEST(SprungClip, IsNotWoundUp) {
  for (int seed = 0; seed < 20; ++seed) {
    const double turn = 0.3 * seed;
    ClipConstraint constraint = fixedClip();
    constraint.rotation = {ClipFreedom::sprung(5.0), ClipFreedom::sprung(3.0), ClipFreedom::sprung(4.0)};
    Harness harness = clamped(uniformCable(0.4, roundSection(6e4, 2.4e4, 0.25, 0.33, 0.08, 4e-3)),
                              poseAt(0.25, 0.1, 0.05, {0.7, 0.3 * seed, 0.4}));
    harness.clips.push_back(
        clipOn(0, "spring", 0.18, constraint, poseAt(0.12, 0.05, 0.02, {turn, -0.5 * turn, 0.8 * turn})));
    const Equilibrium result = solve(harness);
    if (!result.converged()) continue;
    const Pose& clip = harness.clips[2].pose;
    const Eigen::Vector3d wound =
        so3::log(clip.orientation.conjugate() * result.clip_reactions[2].section.orientation);
    const double energy =
        0.5 * (5.0 * wound.x() * wound.x() + 3.0 * wound.y() * wound.y() + 4.0 * wound.z() * wound.z());
    EXPECT_NEAR(result.energy.springs, energy, 1e-6 * (1.0 + energy)) << seed;
  }
}

// Pressed a little beyond Euler's load a column bends over: straight it is stationary, and its Hessian
// without the load's own stress is positive.
TEST(SlenderColumn, BendsOverWhateverItsStretch) {
  for (const double slenderness : {1e4, 1e6, 1e7, 1e9}) {
    for (const double over : {1.005, 1.01, 1.1, 1.3}) {
      SCOPED_TRACE(testing::Message() << "slenderness " << slenderness << ", " << over << " P");
      const double EA = slenderness;
      Harness harness = cantilever(uniformCable(1.0, roundSection(EA, 0.4 * EA, 0.8, 1.0)), kWeightless);
      harness.loads = {loadAt(0, 1.0, {-over * M_PI * M_PI / 4.0, 0.0, 0.0})};
      const Equilibrium result = solve(harness);
      ASSERT_TRUE(result.converged()) << result.message;
      EXPECT_GE(result.smallest_eigenvalue, 0.0);
      EXPECT_GT(result.shapes[0].points.back().pose.position.tail<2>().norm(), 0.05);
    }
  }
}

// The same for a pinned one whose end may slide towards the other: the load must not carry it right over.
TEST(SlenderColumn, PinnedStaysBetweenItsEnds) {
  for (const double slenderness : {1e4, 1e6, 1e7, 1e8}) {
    Section section = roundSection(slenderness, 0.4 * slenderness, 5.0, 1.0);
    section.EI_y = 5.0;
    Harness harness;
    harness.gravity.setZero();
    harness.cables = {uniformCable(1.0, section)};
    ClipConstraint guide;
    guide.translation[0] = ClipFreedom::free();
    guide.rotation[2] = ClipFreedom::free();
    harness.clips = {clipOn(0, "A", 0.0, hingeClip(Axis::z)),
                     clipOn(0, "B", 1.0, guide, poseAt(1.0, 0.0, 0.0))};
    harness.loads = {loadAt(0, 1.0, {-13.0, 0.0, 0.0})};
    const Equilibrium result = solve(harness);
    ASSERT_TRUE(result.converged()) << result.message;
    EXPECT_GT(result.smallest_eigenvalue, 0.0);
    // elastica with 13/π² of Euler's load (Timoshenko and Gere, Theory of Elastic Stability, §2.7)
    EXPECT_NEAR(result.shapes[0].points.back().pose.position.x(), 0.546, 0.03);
  }
}

TEST(UpdatedLoads, JudgesLoadsByTheHarnessToCome) {
  Harness harness = cantilever(uniformCable(0.4, roundSection(1e4, 4e3, 0.02, 0.03, 0.05)));
  harness.loads = {loadAt(0, 0.4, {0.0, 0.0, 0.0}, {0.0, 0.0, 0.0})};
  EquilibriumSolver solver;
  ASSERT_TRUE(solver.solve(harness).converged());
  for (const double moment : {0.05, 0.15, 0.35, 0.6}) {
    harness.loads[0].moment = {moment, 0.3 * moment, 0.0};
    EquilibriumSolver follower = solver;
    const Equilibrium updated = follower.update(harness), alone = solve(harness);
    EXPECT_EQ(updated.status, alone.status) << moment << " N m: " << updated.message;
    EXPECT_EQ(updated.converged(), alone.converged());
  }
}

// Two clips that press a short thick piece together: it is not 'too short'.
TEST(ReasonOfImpossible, PressedTogetherIsNotCalledTooShort) {
  Harness harness = clamped(uniformCable(0.02, roundSection(1e4, 4e3, 0.2, 0.25, 0.1, 8e-3)),
                            poseAt(0.012, 0.0, 0.0), kWeightless);
  const Equilibrium result = solve(harness);
  if (result.status == EquilibriumStatus::impossible) {
    EXPECT_NE(result.message.find("compressed"), std::string::npos) << result.message;
    EXPECT_EQ(result.message.find("too little length"), std::string::npos) << result.message;
  }
}

// What was met and not chosen is never lower than what was.
TEST(Alternatives, AreNotLowerThanTheAnswer) {
  for (double x = 0.05; x < 0.3; x += 0.05) {
    for (double yaw = -3.0; yaw <= 3.0; yaw += 1.0) {
      const Equilibrium result =
          solve(clamped(uniformCable(0.4, strandOfCaseW()), poseAt(x, 0.05, -0.02, {0.3, 0.0, yaw})));
      if (!result.converged()) continue;
      for (const Alternative& other : result.alternatives) {
        EXPECT_GE(other.energy, result.energy.total() - 1e-9 * std::abs(result.energy.total()));
      }
    }
  }
}

// Straight and without weight: starts that lead to the same, whose energies are rounding; others turn it.
TEST(LowestShape, IsNoAlternativeToItself) {
  for (const double length : {0.05, 0.2, 1.5}) {
    const Harness harness =
        clamped(uniformCable(length, strandOfCaseW()), poseAt(length, 0.0, 0.0), Eigen::Vector3d::Zero());
    const Equilibrium straight = EquilibriumSolver().solve(harness);
    ASSERT_TRUE(straight.converged()) << straight.message;
    for (const Alternative& other : straight.alternatives) EXPECT_GT(other.energy, 1e-3) << length;
  }
}

}  // namespace
}  // namespace cable_variation::test
