// Forces and moments at clips, beside the continuum's by multiple shooting, at the accuracy that scenes have
// by default. Where bending is confined to a short layer beside a clamp, in long soft cables and in taut
// wires, the centreline is right long before they are. Whoever solves keeps them: solve(), update() and
// batches.

#include <cable_variation/equilibrium/batch_solver.h>

#include <cmath>

#include <gtest/gtest.h>

#include <hunt/family.h>
#include <hunt/part_maker.h>
#include <hunt/rotation.h>
#include <hunt/shooting.h>

namespace cable_variation::hunt {
namespace {

constexpr double kAllowed = 1e-3;

// Held a little longer than it is, between clips that turn it by up to `angle` [rad]; layers down to a
// thousandth of its length.
Harness makeTaut(Draw& draw, double angle) {
  const double length = draw.logBetween(0.3, 3.0), EA = draw.logBetween(1e4, 1e6);
  const double EI = EA * length * length / draw.logBetween(1e7, 1e10);
  const double strain = draw.logBetween(3e-6, 1e-3);
  Harness harness;
  harness.cables = {
      makeCable("cable", length, stiffnessSection(EA, EI, 0.77 * EI, draw.logBetween(1e-3, 0.1), 1e-3))};
  const auto clip = [&](const char* name, double arc_length, double place) {
    const double turn = draw.between(-angle, angle), azimuth = draw.between(-M_PI, M_PI);
    const Eigen::Quaterniond tilt = rotationBy({0.0, turn * std::cos(azimuth), turn * std::sin(azimuth)});
    const auto kind = draw.oneOf<ClipConstraint>(
        {fixedClip(), fixedClip(), hingeClip(Axis::y), hingeClip(Axis::z), rollingClip()});
    return makeClip(name, 0, arc_length, "general", kind, {{place, 0.0, 0.0}, tilt});
  };
  harness.clips = {clip("start", 0.0, 0.0), clip("end", length, (1.0 + strain) * length)};
  return harness;
}

// The last clip elsewhere.
Harness moved(Harness harness, double by) {
  Pose& pose = harness.clips.back().pose;
  pose.position += by * harness.cables[0].length * Eigen::Vector3d(-0.5, 0.6, -0.3);
  pose.orientation = pose.orientation * rotationBy({0.0, 0.03, -0.02});
  return harness;
}

struct Tried {
  int solved = 0, in_batches = 0;
};

void expectReactions(const Harness& harness, const Equilibrium& answer) {
  if (!answer.notes.empty()) return;  // says itself what is not right
  const ShotReactions exact = shoot(harness, answer);
  if (exact.solved) {
    EXPECT_LT(exact.errorOf(answer), kAllowed);
  }
}

void expectWhoeverSolves(const Harness& harness, double by, Tried& tried) {
  EquilibriumSolver solver;
  const Equilibrium answer = solver.solve(harness);
  if (!answer.converged()) return;
  ++tried.solved;
  expectReactions(harness, answer);
  BatchSolver batch(solver);
  const Harness near_by = moved(harness, by);
  const Equilibrium followed = solver.update(near_by);
  if (followed.converged()) expectReactions(near_by, followed);
  batch.solve(&near_by, 1);
  if (!batch.outcome(0).converged()) return;
  ++tried.in_batches;
  expectReactions(near_by, batch.describe(0));
}

TEST(Reactions, OfLongSoftCablesAreThoseOfTheContinuum) {
  Tried tried;
  for (std::uint64_t i = 0; i < 40; ++i) {
    SCOPED_TRACE(i);
    expectWhoeverSolves(makeHarness(familyOf("long_soft"), 5, i), 2e-3, tried);
  }
  EXPECT_GE(tried.solved, 39);
  EXPECT_GE(tried.in_batches, 20);
}

TEST(Reactions, OfTautWiresAreThoseOfTheContinuum) {
  Tried tried;
  for (std::uint64_t i = 0; i < 40; ++i) {
    SCOPED_TRACE(i);
    Draw draw(5, 99, i);
    expectWhoeverSolves(makeTaut(draw, i % 2 == 0 ? 0.3 : 0.6), 1e-6, tried);
  }
  EXPECT_GE(tried.solved, 39);
  EXPECT_GE(tried.in_batches, 8);
}

TEST(Reactions, OfClipsOfEveryKindAreThoseOfTheContinuum) {
  Tried tried;
  for (const char* family : {"two_ends", "preformed", "thin_wire", "several_clips", "slender"}) {
    for (std::uint64_t i = 0; i < 12; ++i) {
      SCOPED_TRACE(testing::Message() << family << " " << i);
      const Harness harness = makeHarness(familyOf(family), 7, i);
      bool slides = false;
      for (const Clip& clip : harness.clips) slides = slides || clip.constraint.slides;
      if (!slides) expectWhoeverSolves(harness, 1e-4, tried);
    }
  }
  EXPECT_GE(tried.solved, 35);
}

}  // namespace
}  // namespace cable_variation::hunt
