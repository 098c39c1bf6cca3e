// Envelopes over recordings as of a hand-held camera: nothing sticks out at any time, memory is bounded, and
// what is made coarser is told.
#include <cable_variation/envelope/envelope_generator.h>

#include <sys/resource.h>

#include <cmath>
#include <stdexcept>
#include <string>

#include <gtest/gtest.h>

#include <cable_variation/geometry/mesh/box.h>
#include <cable_variation/tracking/motion_phases.h>

#include "envelope_scenes.h"
#include "hand_held.h"

namespace cable_variation::test {
namespace {

using Eigen::Vector3d;

constexpr double kRadius = 0.012;  // [m]

double peakMemory() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return 1024.0 * static_cast<double>(usage.ru_maxrss);
}

// A soft cable of 0.9 m that hangs from a wall to a part in somebody's hand.
Scene cableToTheHand(const HandHeld& how) {
  Section section = roundSection(2e3, 7e2, 0.02, 0.016, 0.05, kRadius);
  Scene scene =
      sceneOf(clamped(uniformCable(0.9, section), poseAt(0.45, 0.0, -0.2), Vector3d(0.0, 0.0, -9.81)));
  scene.accuracy = 2e-4;
  Component hand;
  hand.name = "hand";
  hand.pose = scene.harness.clips[1].pose;
  scene.components = {hand};
  scene.clip_mounts[1] = {"hand", Pose()};
  Motion motion;
  motion.name = "carried";
  motion.component = "hand";
  motion.samples = handHeldRecording(hand.pose, how);
  scene.motions = {motion};
  return scene;
}

EnvelopeOptions over(double seconds) {
  EnvelopeOptions options;
  options.motions = {0};
  options.to = seconds;
  options.verification = 200;
  return options;
}

Envelope generate(const Scene& scene, const EnvelopeOptions& options) {
  EquilibriumSolver solver = solverOf(scene);
  if (!solver.solve(scene.harness).converged()) throw std::runtime_error("not solved");
  return generateEnvelope(scene, options, solver);
}

// As outside(), of many pieces: those whose box is too far away are not looked at.
class Pieces {
 public:
  explicit Pieces(const std::vector<EnvelopePiece>& pieces) : pieces_(pieces) {
    for (const EnvelopePiece& piece : pieces) {
      Box box;
      for (const Vector3d& vertex : piece.body.core.surface().vertices) box.add(vertex);
      boxes_.push_back(box);
    }
  }
  bool hold(const Vector3d& point, double radius) const {
    for (std::size_t i = 0; i < boxes_.size(); ++i) {
      const Eigen::Array3d off = (boxes_[i].low - point.array()).max(point.array() - boxes_[i].high).max(0.0);
      const double room = pieces_[i].body.radius - radius;
      if (off.matrix().norm() <= room && pieces_[i].body.core.closest(point).distance <= room) return true;
    }
    return false;
  }

 private:
  const std::vector<EnvelopePiece>& pieces_;
  std::vector<Box> boxes_;
};

// Solved here, one after the other along the whole recording; random places between its poses, too.
TEST(recording, no_shape_at_any_time_sticks_out) {
  for (const double rate : {30.0, 200.0}) {
    HandHeld how;
    how.seconds = 3.0;
    how.rate = rate;
    how.repeated_every = 7;
    const Scene scene = cableToTheHand(how);
    const Envelope envelope = generate(scene, over(how.seconds));
    EquilibriumSolver following = solverOf(scene);
    ASSERT_TRUE(following.solve(scene.harness).converged());
    const CounterRandom random(5, 1);
    const Pieces pieces(envelope.frames[0].pieces);
    double time = 0.0;
    for (std::uint64_t i = 0; time < how.seconds; ++i) {
      const Harness harness = harnessAt(scene, {}, {{"hand", poseAt(scene.motions[0], time)}});
      const Equilibrium shape = following.update(harness);
      ASSERT_TRUE(shape.converged()) << time;
      for (double s = 0.0; s <= 0.9; s += 0.045) {
        EXPECT_TRUE(pieces.hold(shape.shapes[0].position(s), kRadius))
            << rate << " Hz, " << time << " s, " << s << " m";
      }
      time += 0.03 * RandomRow(random, i).uniform();
    }
  }
}

TEST(recording, straight_ways_make_long_phases_and_jitter_few) {
  HandHeld how;
  how.seconds = 10.0;
  const Scene scene = cableToTheHand(how);
  const VariedDesign design{{}, {0}, {}, {}};
  const SampleSpace space(scene, design);
  PhaseRule rule;
  rule.stride = 0.003;
  rule.lever = 0.2;
  const auto any_way = cutIntoPhases(space, {"world"}, 0.0, how.seconds, rule);
  rule.reach = 0.018;
  rule.bow = 3e-4;
  const auto straight = cutIntoPhases(space, {"world"}, 0.0, how.seconds, rule);
  EXPECT_LT(2 * straight.size(), any_way.size());
  for (std::size_t i = 0; i < straight.size(); ++i) {
    EXPECT_LE(straight[i].excess, rule.stride);
    EXPECT_EQ(straight[i].times.front(), i == 0 ? 0.0 : straight[i - 1].times.back());
  }
  EXPECT_EQ(straight.back().times.back(), how.seconds);

  rule.most = 40;
  std::size_t wanted = 0;
  const auto few = cutIntoPhases(space, {"world"}, 0.0, how.seconds, rule, &wanted);
  EXPECT_EQ(wanted, straight.size());
  EXPECT_LE(few.size(), 40U);
  EXPECT_GE(few.size(), 20U);
  const auto excessOf = [](const std::vector<MotionPhase>& phases) {
    double excess = 0.0;
    for (const MotionPhase& phase : phases) excess = std::max(excess, phase.excess);
    return excess;
  };
  EXPECT_GT(excessOf(few), excessOf(straight));

  how.reach = 1e-3;
  how.turn = 0.0;
  const Scene still = cableToTheHand(how);
  EXPECT_EQ(cutIntoPhases(SampleSpace(still, design), {"world"}, 0.0, how.seconds, rule).size(), 1U);
}

// The middle of a half circle's diameter is a radius off it; of a straight way nothing is off.
TEST(recording, excess_is_how_far_hulls_bridge) {
  constexpr double kWay = 0.01;
  Scene scene = cableToTheHand({});
  const VariedDesign design{{}, {0}, {}, {}};
  const auto excessOf = [&](const std::function<Vector3d(double)>& way) {
    scene.motions[0].samples.clear();
    for (int i = 0; i <= 200; ++i)
      scene.motions[0].samples.push_back({0.01 * i, {way(0.005 * i), Eigen::Quaterniond::Identity()}});
    PhaseRule rule;
    rule.stride = 1.0;
    const auto phases = cutIntoPhases(SampleSpace(scene, design), {"world"}, 0.0, 2.0, rule);
    EXPECT_EQ(phases.size(), 1U);
    return phases.front().excess;
  };
  const double of_half_circle = excessOf([](double share) {
    return Vector3d(kWay * std::cos(M_PI * share), kWay * std::sin(M_PI * share), 0.0);
  });
  EXPECT_NEAR(of_half_circle, kWay, 0.02 * kWay);
  EXPECT_NEAR(excessOf([](double share) { return Vector3d(0.3 * share * share, 0.1 * share * share, 0.0); }),
              0.0, 1e-12);
}

// With a limit that is too small for all phases.
TEST(recording, is_made_in_bounded_memory) {
  constexpr double kLimit = 8e7;  // [B]
  HandHeld how;
  how.seconds = 8.0;
  const Scene scene = cableToTheHand(how);
  EnvelopeOptions options = over(how.seconds);
  options.memory_limit = kLimit;
  const double before = peakMemory();
  const Envelope envelope = generate(scene, options);
  EXPECT_LE(peakMemory() - before, 2.0 * kLimit);
  EXPECT_GT(envelope.phases.size(), 10U);
  EXPECT_GT(envelope.motion_excess, 0.0);
  ASSERT_FALSE(envelope.warnings.empty());
  bool told = false;
  for (const std::string& warning : envelope.warnings)
    told = told || warning.find("longer ones are taken") != std::string::npos;
  EXPECT_TRUE(told);
  // with so little memory each phase has few shapes, and what they miss is found and said
  EXPECT_LE(envelope.containment.outside, 5U);
  EXPECT_LT(envelope.containment.largest_excess, 1e-3);
}

std::string refusal(const Scene& scene, const EnvelopeOptions& options) {
  try {
    generate(scene, options);
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "";
}

TEST(recording, what_would_take_more_memory_than_allowed_is_refused_beforehand) {
  HandHeld how;
  how.seconds = 0.2;
  const Scene scene = cableToTheHand(how);
  const auto expectRefusal = [&](const EnvelopeOptions& options, const std::string& field) {
    const std::string message = refusal(scene, options);
    EXPECT_EQ(message.find(field), 0U) << message;
    EXPECT_NE(message.find("would take"), std::string::npos) << message;
    EXPECT_NE(message.find("of the limit of"), std::string::npos) << message;
  };
  EnvelopeOptions options = over(how.seconds);
  options.tightness = 1;
  options.voxel = 1e-6;
  expectRefusal(options, "tightness_voxel: 1e-06 m");
  options = over(how.seconds);
  options.memory_limit = 1e4;
  expectRefusal(options, "variables: 0");
  options.memory_limit = -1.0;
  EXPECT_NE(refusal(scene, options).find("memory_limit: -1"), std::string::npos);
}

// Asked for finer voxels than memory is enough for around the whole of it, tightness has larger ones.
TEST(recording, tightness_keeps_to_its_memory) {
  HandHeld how;
  how.seconds = 1.0;
  const Scene scene = cableToTheHand(how);
  EnvelopeOptions options = over(how.seconds);
  options.tightness = 20;
  options.memory_limit = 2e7;
  const double before = peakMemory();
  const Envelope envelope = generate(scene, options);
  EXPECT_LE(peakMemory() - before, 3.0 * options.memory_limit);
  EXPECT_GT(envelope.tightness.voxel, 0.001);
  EXPECT_GT(envelope.tightness.ratio(), 1.0);
}

}  // namespace
}  // namespace cable_variation::test
