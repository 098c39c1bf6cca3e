// What lies near a cable's clips on a component does not count against it, to the place where that ends: of
// random rods that leave a box, against the closed form and against harnesses drawn and solved apart.
#include <cable_variation/envelope/clearance/clip_offsets.h>

#include <algorithm>
#include <random>
#include <string>

#include <gtest/gtest.h>

#include <cable_variation/envelope/clearance/clearance_skips.h>
#include <cable_variation/envelope/clearance/closest_solved.h>
#include <cable_variation/envelope/search/random_place.h>
#include <cable_variation/geometry/tube_distance/distance.h>
#include <cable_variation/measures/cable_view.h>
#include <cable_variation/scene/deviations.h>

#include "envelope_scenes.h"

namespace cable_variation::test {
namespace {

using Eigen::Vector3d;

constexpr double kDegree = M_PI / 180.0;
constexpr double kBox = 0.04;  // [m]

struct Made {
  Scene scene;
  EnvelopeOptions options;
  ClearanceOptions clearance_options;

  void vary() {
    options.variables.resize(scene.design_variables.size());
    for (std::size_t i = 0; i < options.variables.size(); ++i) options.variables[i] = i;
    options.margin = 5e-5;
    options.verification = 200;
  }

  EquilibriumSolver solver() const {
    EquilibriumSolver solver = solverOf(scene);
    EXPECT_TRUE(solver.solve(scene.harness).converged());
    return solver;
  }

  // To the box.
  EnvelopeClearance clearance() const {
    const EquilibriumSolver of = solver();
    ClosestSolved closest(scene, options, {}, of, clearance_options);
    EnvelopeOptions cut = options;
    cut.cuts = closest.cuts();
    const Envelope envelope = generateEnvelope(scene, cut, of, {}, closest.witness());
    return clearances(scene, envelope, cut, {}, of, clearance_options, &closest).at(0);
  }

  // The closest that harnesses drawn here come to the box.
  double closestDrawn(std::uint64_t count) const {
    const SampleSpace space(scene, options);
    const CounterRandom random(7, 1);
    ComponentParts parts;
    parts.prepareAll(scene, {});
    const EquilibriumSolver of = solver();
    double least = 1.0;
    for (std::uint64_t i = 0; i < count; ++i) {
      const SamplePlace place = drawPlace(space, 0.0, 0.0, random, i);
      const Harness harness = space.harness(place);
      EquilibriumSolver aside = of;
      const Equilibrium equilibrium = aside.update(harness);
      EXPECT_TRUE(equilibrium.converged());
      const auto skipped =
          stretchesNearClips(scene, harness, equilibrium, 0, "box", *clearance_options.skip_near_clips);
      const auto pair = distance(centrelineOf(harness.cables[0], equilibrium.shapes[0]), *parts.find(0),
                                 space.components(place).at("box"), skipped);
      if (pair) least = std::min(least, pair->distance);
    }
    return least;
  }
};

// A rod held by its start in the middle of a box's face, which it leaves along x.
Made leavingABox(double length, double radius, double near) {
  Made made;
  made.scene = freeRod(length, radius);
  made.scene.components = {
      boxPart("box", {kBox, kBox, kBox}, {{-0.5 * kBox, 0.0, 0.0}, Eigen::Quaterniond::Identity()})};
  made.scene.clip_mounts[0] = {"box", poseAt(0.5 * kBox, 0.0, 0.0)};
  made.clearance_options.skip_near_clips = near;
  return made;
}

TEST(clearance_skips, end_where_they_should_whatever_the_pieces_of_the_envelope) {
  std::mt19937 generator(20);
  const auto between = [&](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(generator);
  };
  for (int i = 0; i < 12; ++i) {
    const double length = between(0.1, 0.4), radius = between(0.002, 0.008);
    const double near = between(0.05, 0.8) * length, longer = i % 2 == 0 ? 0.0 : between(0.0, 0.04) * length;
    const double turn = between(0.1, 2.0) * kDegree;
    Made made = leavingABox(length, radius, near);
    addVariable(made.scene, "turn", ClipRotation{0, Axis::y}, -turn, turn);
    if (longer > 0.0) {
      DesignVariable own = variable("length", CableProperty{0, CableProperty::Property::length}, length);
      own.lower = -longer;
      own.upper = longer;
      own.distribution_parameters["sigma"] = 3.0;
      made.scene.design_variables.push_back(own);
    }
    made.vary();
    const double exact = near * std::cos(turn) - radius;  // at the place where the skipped stretch ends
    const EnvelopeClearance found = made.clearance();
    const std::string which = "rod " + std::to_string(i) + ", near " + std::to_string(near) + " m of " +
                              std::to_string(length) + " m, longer by " + std::to_string(longer) + " m";
    EXPECT_LE(found.distance, exact + 1e-9) << which;
    // the material that is `near` in the shortest rod is further in the longest one
    EXPECT_GE(found.distance, exact - near * 2.0 * longer / length - 3.0 * made.options.margin) << which;
    EXPECT_NEAR(found.worst_sample, exact, 1e-4) << which;
  }
}

// A rod slides through a ring of a box, pushed by the clip at its start: what lies near the ring does not
// count, wherever the rod is.
TEST(clearance_skips, follow_clips_in_which_a_cable_slides) {
  std::mt19937 generator(21);
  const auto between = [&](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(generator);
  };
  for (int i = 0; i < 6; ++i) {
    const double radius = between(0.002, 0.004), near = between(0.03, 0.06), push = between(0.002, 0.012);
    Made made;
    Harness harness = cantilever(uniformCable(0.3, rodOfRadius(radius)), Vector3d::Zero());
    Clip ring = clipOn(0, "ring", 0.15, slidingClip());
    ring.pose = poseAt(0.15, 0.0, 0.0);
    harness.clips.push_back(ring);
    made.scene = sceneOf(harness);
    made.scene.accuracy = 1e-5;
    made.scene.components = {
        boxPart("box", {kBox, kBox, kBox}, {{0.15, 0.0, 0.0}, Eigen::Quaterniond::Identity()})};
    made.scene.clip_mounts[1] = {"box", Pose{}};
    addVariable(made.scene, "push", ClipTranslation{0, Axis::x}, -push, push);
    made.clearance_options.skip_near_clips = near;
    made.vary();
    const EnvelopeClearance found = made.clearance();
    const double exact = near - 0.5 * kBox - radius;  // in space: the ring stays
    const std::string which = "rod " + std::to_string(i) + ", near " + std::to_string(near) + " m, push " +
                              std::to_string(push) + " m";
    EXPECT_NEAR(made.closestDrawn(50), exact, 1e-5) << which;
    EXPECT_LE(found.distance, exact + 1e-9) << which;
    EXPECT_GE(found.distance, exact - 0.25 * near - 3.0 * made.options.margin) << which;
  }
}

TEST(clip_offsets, are_those_of_the_extremes_of_lengths_and_places) {
  Made made = leavingABox(0.2, 0.004, 0.05);
  made.scene.harness.clips.push_back(clipOn(0, "tie", 0.12, freeClip()));
  made.scene.clip_mounts.push_back({"world", poseAt(0.12, 0.0, 0.0)});
  DesignVariable place = variable("place", ClipArcLength{1}, 0.12);
  place.lower = -0.006;
  place.upper = 0.012;
  made.scene.design_variables = {place};
  made.vary();
  EquilibriumSolver solver = solverOf(made.scene);
  const Equilibrium equilibrium = solver.solve(made.scene.harness);
  ASSERT_TRUE(equilibrium.converged());
  const SampleSpace space(made.scene, made.options);
  ClipOffsets offsets(space, space.designAt(0.0), equilibrium);
  EXPECT_NEAR(offsets.largest(0, 0.12), 0.132, 1e-12);
  EXPECT_NEAR(offsets.largest(0, 0.06), 0.066, 1e-12);  // half of the way to it
  EXPECT_NEAR(offsets.largest(1, 0.0), 0.132, 1e-12);
  EXPECT_NEAR(offsets.largest(1, 0.2), 0.086, 1e-12);  // the end stays where it is
  const std::vector<double> places = offsets.placesWithin(0, 0.066);
  ASSERT_EQ(places.size(), 1U);
  EXPECT_NEAR(places[0], 0.06, 1e-12);
  EXPECT_TRUE(offsets.placesWithin(0, 0.3).empty());
}

}  // namespace
}  // namespace cable_variation::test
