#include <cable_variation/envelope/clearance/envelope_clearance.h>

#include <cmath>
#include <stdexcept>

#include <gtest/gtest.h>

#include <measures/solved_scene.h>

namespace cable_variation {
namespace {

using Eigen::Vector3d;

constexpr double kLength = 0.2, kRadius = 0.004, kInflation = 1e-4, kSwing = 0.005;  // [m]
constexpr double kStretch = 0.02;
constexpr double kAdded = 3e-6;  // twice the body that flat hulls are given, and rounding [m]

/// Straight cables along x, at y = 0 and one more every 50 mm. The one variable lifts them along z [m].
struct World {
  Scene scene;
  Envelope envelope;
  EnvelopeOptions options;

  explicit World(std::size_t cables = 1) {
    Harness harness;
    for (std::size_t i = 0; i < cables; ++i) {
      harness.cables.push_back(test::uniformCable(kLength, test::roundSection(1, 1, 1, 1, 0, kRadius)));
      harness.clips.push_back(test::clipOn(i, "clip", 0.0, fixedClip()));
      envelope.cables.push_back(i);
    }
    scene = test::sceneOf(harness);
    scene.design_variables = {test::variable("lift", ClipTranslation{0, Axis::z})};
    options.variables = envelope.variables = {0};
    envelope.inflation = kInflation;
    envelope.frames.resize(1);
  }

  void addPart(const std::string& name, const Vector3d& size, const Vector3d& at) {
    scene.components.push_back(test::boxPart(name, size, {at, Eigen::Quaterniond::Identity()}));
  }

  /// At each of the times the cables at rest, lifted and lowered; the first is the design.
  void addPhase(double start, double end, const std::vector<double>& times) {
    const std::size_t phase = envelope.phases.size(), first = envelope.samples.size();
    envelope.phases.push_back({start, end, times.size()});
    for (const double time : times) {
      for (const double lift : {0.0, kSwing, -kSwing}) {
        envelope.samples.push_back({Eigen::VectorXd::Constant(1, lift), time, phase, 0});
      }
    }
    for (EnvelopeFrame& frame : envelope.frames) {
      for (const std::size_t cable : envelope.cables) {
        for (double s = 0.0; s < kLength - 1e-9; s += kStretch) addPiece(frame, cable, s, phase, first);
      }
    }
  }

  SolvedSample solve(const EnvelopeSample& sample) const {
    SolvedSample solved{scene.harness, {}, componentsAt(sample.time)};
    solved.equilibrium.status = EquilibriumStatus::converged;
    for (std::size_t cable = 0; cable < scene.harness.cables.size(); ++cable) {
      CableShape shape;
      shape.radius = kRadius;
      for (double s = 0.0; s < kLength + 1e-9; s += 0.5 * kStretch) {
        ShapePoint point;
        point.arc_length = s;
        point.pose.position = at(cable, s, sample);
        point.tangent = Vector3d::UnitX();
        shape.points.push_back(point);
      }
      solved.equilibrium.shapes.push_back(shape);
    }
    for (const Clip& clip : scene.harness.clips) {
      Reaction reaction;
      reaction.arc_length = clip.arc_length;
      solved.equilibrium.clip_reactions.push_back(reaction);
    }
    return solved;
  }

  std::vector<EnvelopeClearance> find(const ClearanceOptions& own = {}) const {
    const SampleSolver solver = [this](const EnvelopeSample& sample) { return solve(sample); };
    return clearances(scene, envelope, options, ComponentParts(), solver, own);
  }

 private:
  static Vector3d at(std::size_t cable, double s, const EnvelopeSample& sample) {
    return {s, 0.05 * static_cast<double>(cable), sample.deviations[0]};
  }

  ComponentPoses componentsAt(double time) const {
    ComponentPoses moved;
    for (const Motion& motion : scene.motions) moved[motion.component] = poseAt(motion, time);
    return componentPosesAt(scene, {}, moved);
  }

  void addPiece(EnvelopeFrame& frame, std::size_t cable, double s, std::size_t phase, std::size_t first) {
    std::vector<Vector3d> points;
    std::vector<std::size_t> from;
    for (std::size_t i = first; i < envelope.samples.size(); ++i) {
      const EnvelopeSample& sample = envelope.samples[i];
      Pose seen;
      if (frame.component != "world") seen = componentsAt(sample.time).at(frame.component).inverse();
      for (const double end : {s, s + kStretch}) {
        points.push_back(seen * at(cable, end, sample));
        from.push_back(i);
      }
    }
    EnvelopePiece piece{cable, s, s + kStretch, phase, 0, {ConvexHull(points), kRadius + kInflation}, {}};
    for (const std::size_t source : piece.body.core.sources()) {
      piece.vertex_sample.push_back(source == ConvexHull::kAdded ? first : from[source]);
    }
    frame.pieces.push_back(piece);
  }
};

// A box whose lower face is 30 mm above the cable at x from 130 to 150 mm.
TEST(EnvelopeClearance, OfAComponentAtRest) {
  World world;
  world.addPart("roof", {0.02, 0.1, 0.02}, {0.14, 0.0, 0.04});
  world.addPhase(0.0, 0.0, {0.0});
  const std::vector<EnvelopeClearance> found = world.find();
  ASSERT_EQ(found.size(), 1u);
  const EnvelopeClearance& to = found[0];
  EXPECT_EQ(to.component, "roof");
  EXPECT_FALSE(to.other);
  EXPECT_NEAR(to.distance, 0.03 - kSwing - kRadius - kInflation, 1e-9);
  EXPECT_NEAR(to.worst_sample, 0.03 - kSwing - kRadius, 1e-9);
  EXPECT_NEAR(to.nominal, 0.03 - kRadius, 1e-9);
  EXPECT_EQ(to.deviations[0], kSwing);
  EXPECT_GE(to.arc_length, 0.13 - 1e-9);
  EXPECT_LE(to.arc_length, 0.15 + 1e-9);
  EXPECT_NEAR(to.on_envelope.x(), to.arc_length, 1e-6);
  EXPECT_NEAR(to.on_envelope.z(), kSwing + kRadius + kInflation, 1e-9);
  EXPECT_NEAR(to.on_other.z(), 0.03, 1e-9);
  EXPECT_TRUE(to.colliding.empty());
}

// The box reaches 2 mm below the lifted cable's top: into what is round, above the core. Its lower face and
// the lower ends of its sides enter: all but the upper face's two triangles.
TEST(EnvelopeClearance, OverlapIsNegativeAndNamesTheTrianglesThatEnter) {
  World world;
  world.addPart("roof", {0.02, 0.1, 0.02}, {0.14, 0.0, kSwing + kRadius - 0.002 + 0.01});
  world.addPhase(0.0, 0.0, {0.0});
  const EnvelopeClearance to = world.find().at(0);
  EXPECT_NEAR(to.distance, -0.002 - kInflation, 1e-9);
  EXPECT_NEAR(to.worst_sample, -0.002, 1e-9);
  EXPECT_NEAR(to.nominal, kSwing - 0.002, 1e-9);
  const TriangleMesh mesh = mergedMesh(world.scene.components[0]);
  std::size_t below = 0;
  for (const std::uint32_t triangle : to.colliding) {
    double lowest = 1.0;
    Vector3d centre = Vector3d::Zero();
    for (const std::uint32_t corner : mesh.triangles[triangle]) {
      lowest = std::min(lowest, mesh.vertices[corner].z());
      centre += mesh.vertices[corner] / 3.0;
    }
    EXPECT_EQ(lowest, -0.01) << "the upper face is far away";
    EXPECT_LT(std::abs(centre.y()), 0.04) << "the sides are far away";
    below += centre.z() < -0.0099;
  }
  EXPECT_EQ(below, 2u) << "the lower face";
}

// Wholly in a solid: a piece says how deep its corners lie, a solved cable how deep its deepest place; the
// envelope is at least as deep as either.
TEST(EnvelopeClearance, IsNoMoreThanThatOfASolvedHarness) {
  World world;
  world.addPart("block", {1.0, 0.3, 0.1}, {0.1, 0.0, 0.04});
  world.addPhase(0.0, 0.0, {0.0});
  const EnvelopeClearance to = world.find().at(0);
  // the lower face at z = -0.01, the cable lifted by 5 mm is 15 mm above
  EXPECT_NEAR(to.worst_sample, -0.015 - kRadius, 1e-8);
  EXPECT_LE(to.distance, to.worst_sample);
  EXPECT_NEAR(to.distance, -0.015 - kRadius - kInflation, 1e-8);
}

World movingFloor() {
  World world;
  world.addPart("floor", {1.0, 0.1, 0.02}, Vector3d::Zero());
  Motion motion;
  motion.name = "rise";
  motion.component = "floor";
  // its upper face 10 mm above its middle: at -50 mm at first, at -20 mm after a second
  motion.samples = {{0.0, {{0.0, 0.0, -0.06}, Eigen::Quaterniond::Identity()}},
                    {1.0, {{0.0, 0.0, -0.03}, Eigen::Quaterniond::Identity()}}};
  world.scene.motions = {motion};
  world.options.motions = {0};
  return world;
}

TEST(EnvelopeClearance, OfAMovingComponentIsSeenFromIt) {
  World world = movingFloor();
  EXPECT_EQ(clearanceFrames(world.scene, world.options), std::vector<std::string>{"floor"});
  world.envelope.frames.push_back({"floor", {}});
  world.addPhase(0.0, 0.5, {0.25, 0.0, 0.5});
  world.addPhase(0.5, 1.0, {0.75, 0.5, 1.0});
  const EnvelopeClearance to = world.find().at(0);
  EXPECT_NEAR(to.distance, 0.02 - kSwing - kRadius - kInflation, 1e-9);
  EXPECT_EQ(to.time, 1.0);
  EXPECT_EQ(to.deviations[0], -kSwing);
  EXPECT_NEAR(to.on_other.z(), -0.02, 1e-9);
  EXPECT_NEAR(to.on_envelope.z(), -kSwing - kRadius - kInflation, 1e-9);
  EXPECT_NEAR(to.nominal, 0.02 - kRadius, 1e-9);
  EXPECT_NEAR(to.nominal_time, 1.0, 1e-12);
  EXPECT_NEAR(to.worst_sample, 0.02 - kSwing - kRadius, 1e-9);
}

// The floor rises and falls again, highest at 0.58 s; the phase is looked at in quarters, then in halves of
// these down to 1/32 of a quarter.
TEST(EnvelopeClearance, LooksForTheNominalOverAPhase) {
  World world = movingFloor();
  world.scene.motions[0].samples = {{0.0, {{0.0, 0.0, -0.06}, Eigen::Quaterniond::Identity()}},
                                    {0.58, {{0.0, 0.0, -0.03}, Eigen::Quaterniond::Identity()}},
                                    {1.0, {{0.0, 0.0, -0.06}, Eigen::Quaterniond::Identity()}}};
  world.envelope.frames.push_back({"floor", {}});
  world.addPhase(0.0, 1.0, {0.0, 0.58, 1.0});
  const EnvelopeClearance to = world.find().at(0);
  EXPECT_NEAR(to.nominal_time, 0.58, 0.25 / 32.0);
  // it moves by 30 mm in 0.42 s
  EXPECT_NEAR(to.nominal, 0.02 - kRadius, 0.03 / 0.42 * 0.25 / 32.0);
}

TEST(EnvelopeClearance, RefusesAMovingComponentThatItIsNotSeenFrom) {
  World world = movingFloor();
  world.addPhase(0.0, 1.0, {0.0, 1.0});
  EXPECT_THROW(world.find(), std::invalid_argument);
}

// What rides on a moving component is measured in its frame.
TEST(EnvelopeClearance, OfAComponentThatRidesOnAMovingOne) {
  World world = movingFloor();
  world.addPart("post", {0.02, 0.02, 0.02},
                {0.1, 0.0, 0.015});  // its upper face 25 mm above the floor's middle
  world.scene.components[1].parent = "floor";
  EXPECT_EQ(clearanceFrames(world.scene, world.options), std::vector<std::string>{"floor"});
  world.envelope.frames.push_back({"floor", {}});
  world.addPhase(0.0, 1.0, {0.0, 1.0});
  EXPECT_NEAR(world.find().at(1).distance, 0.005 - kSwing - kRadius - kInflation, 1e-9);
}

// Clipped at its start onto the wall it touches there.
TEST(EnvelopeClearance, SkipsSectionsNearItsOwnClips) {
  World world;
  world.addPart("wall", {0.02, 0.1, 0.1}, {-0.01, 0.0, 0.0});
  world.scene.clip_mounts[0].component = "wall";
  world.addPhase(0.0, 0.0, {0.0});
  // the stretch from 20 to 40 mm reaches beyond 30 mm and counts as a whole
  EXPECT_NEAR(world.find().at(0).distance, 0.02 - kRadius - kInflation, kAdded);
  EXPECT_NEAR(world.find().at(0).nominal, 0.03 - kRadius, 1e-9);

  ClearanceOptions all;
  all.skip_near_clips = 0.0;
  EXPECT_LE(world.find(all).at(0).distance, -kRadius);

  Measure measure = test::measure(Measure::Type::distance, "D");
  measure.component = 0;
  measure.skip_near_clips = 0.06;
  world.scene.measures = {measure};
  EXPECT_NEAR(world.find().at(0).distance, 0.06 - kRadius - kInflation, kAdded);
  EXPECT_NEAR(world.find().at(0).worst_sample, 0.06 - kRadius, 1e-9);

  ClearanceOptions none;
  none.skip_near_clips = 1.0;
  EXPECT_TRUE(world.find(none).empty());
  none.skip_near_clips = -0.1;
  EXPECT_THROW(world.find(none), std::invalid_argument);
}

// Both swing alike: they stay as far apart as they are, whatever the pieces say.
TEST(EnvelopeClearance, BetweenCables) {
  World world(2);
  world.addPhase(0.0, 0.0, {0.0});
  const std::vector<EnvelopeClearance> found = world.find();
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].cable, 0u);
  EXPECT_EQ(found[0].other, std::optional<std::size_t>(1));
  EXPECT_TRUE(found[0].component.empty());
  EXPECT_NEAR(found[0].between_bodies, 0.05 - 2.0 * (kRadius + kInflation), kAdded);
  EXPECT_EQ(found[0].kind, EnvelopeClearance::Kind::together);
  // twice what is not worth looking for, with the usual margin
  EXPECT_NEAR(found[0].margin, 2.0 * 0.4e-4, 1e-12);
  EXPECT_NEAR(found[0].distance, 0.05 - 2.0 * kRadius - found[0].margin, 1e-9);
  EXPECT_NEAR(found[0].worst_sample, 0.05 - 2.0 * kRadius, 1e-9);
  EXPECT_NEAR(found[0].nominal, 0.05 - 2.0 * kRadius, 1e-9);
  EXPECT_NEAR(found[0].other_arc_length, found[0].arc_length, kStretch + kAdded);
  EXPECT_NEAR(found[0].on_envelope.y(), kRadius, 1e-9);
  EXPECT_NEAR(found[0].on_other.y(), 0.05 - kRadius, 1e-9);
}

// Joined at arc length 0 of both: pieces count that reach a way of 60 mm, the first of them 20 to 40 mm on
// each, or further out on one.
TEST(EnvelopeClearance, BetweenJoinedCablesSkipsTheWayAroundTheJoint) {
  World world(2);
  Joint joint;
  joint.parent = 0;
  joint.child = 1;
  world.scene.harness.joints = {joint};
  world.addPhase(0.0, 0.0, {0.0});
  ClearanceOptions own;
  own.skip_near_joints = 2.0 * kLength + 0.01;
  EXPECT_TRUE(world.find(own).empty());
  own.skip_near_joints = 2.0 * kLength - 0.01;  // only the last pieces of both reach so far
  const EnvelopeClearance last = world.find(own).at(0);
  EXPECT_GE(last.arc_length, kLength - kStretch - 1e-9);
  EXPECT_GE(last.other_arc_length, kLength - kStretch - 1e-9);
}

}  // namespace
}  // namespace cable_variation
