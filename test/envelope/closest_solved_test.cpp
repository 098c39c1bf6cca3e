// The closest of all harnesses solved for an envelope, against the distance of each of them by itself, and
// against shapes drawn apart from them.
#include <cable_variation/envelope/clearance/closest_solved.h>

#include <algorithm>
#include <map>
#include <mutex>

#include <gtest/gtest.h>

#include <cable_variation/envelope/clearance/clearance_skips.h>
#include <cable_variation/envelope/search/random_place.h>
#include <cable_variation/geometry/tube_distance/distance.h>
#include <cable_variation/measures/cable_view.h>
#include <cable_variation/scene/deviations.h>
#include <cable_variation/scene_file/scene_reader.h>

#include "envelope_scenes.h"

namespace cable_variation::test {
namespace {

Scene harnessCase() {
  return readScene(std::string(CABLE_VARIATION_SOURCE_DIR) + "/config/harness.yaml",
                   [](const std::string&) { return std::string(CABLE_VARIATION_SOURCE_DIR); });
}

// Of every cable and component, without limits, hints or a vicinity.
struct Distances {
  const Scene& scene;
  const ComponentParts& parts;
  std::map<std::pair<std::size_t, std::size_t>, std::vector<double>> all;

  void take(const Harness& harness, const Equilibrium& equilibrium, const ComponentPoses& components) {
    for (std::size_t cable = 0; cable < harness.cables.size(); ++cable) {
      const Centreline line = centrelineOf(harness.cables[cable], equilibrium.shapes[cable]);
      for (std::size_t i = 0; i < scene.components.size(); ++i) {
        if (parts.find(i) == nullptr) continue;
        const std::string& name = scene.components[i].name;
        const auto skipped = stretchesNearClips(scene, harness, equilibrium, cable, name,
                                                skippedNearClips(scene, {}, cable, i));
        const auto pair = distance(line, *parts.find(i), components.at(name), skipped);
        if (pair) all[{cable, i}].push_back(pair->distance);
      }
    }
  }
  double least(std::pair<std::size_t, std::size_t> of) const {
    return *std::min_element(all.at(of).begin(), all.at(of).end());
  }
};

TEST(closest_solved, is_the_closest_of_all_that_were_solved_and_few_others_are_closer) {
  const Scene scene = harnessCase();
  EnvelopeOptions options;
  options.variables = {1, 2, 5, 9};  // of clips, a length and a component that moves
  options.frames = clearanceFrames(scene, options);
  options.margin = 5e-4;
  options.verification = 500;
  EquilibriumSolver solver = solverOf(scene);
  ASSERT_TRUE(solver.solve(scene.harness).converged());
  ComponentParts parts;
  parts.prepareAll(scene, {});
  ClosestSolved closest(scene, options, parts, solver);
  const SampleSpace space(scene, options);
  Distances told{scene, parts, {}};
  std::mutex mutex;
  std::size_t count = 0;
  const Envelope envelope =
      generateEnvelope(scene, options, solver, {},
                       [&](const SamplePlace& place, const Harness& harness, const Equilibrium& equilibrium) {
                         EXPECT_TRUE(space.tolerances().contains(place.deviations));
                         closest.take(place, harness, equilibrium);
                         const ComponentPoses components = space.components(place);
                         const std::lock_guard<std::mutex> lock(mutex);
                         // each at its own distances takes too long: those for containment are the most, and
                         // enough
                         if (++count % 4 == 0) told.take(harness, equilibrium, components);
                       });
  EXPECT_EQ(closest.taken(), count);
  EXPECT_GE(count, options.verification + envelope.solves);
  const auto found = clearances(scene, envelope, options, parts, solver, {}, &closest);

  // drawn and solved here
  Distances drawn{scene, parts, {}};
  const CounterRandom random(99, 1);
  for (std::uint64_t i = 0; i < 300; ++i) {
    const SamplePlace place = drawPlace(space, 0.0, 0.0, random, i);
    EquilibriumSolver aside = solver;
    const Harness harness = space.harness(place);
    const Equilibrium equilibrium = aside.update(harness);
    ASSERT_TRUE(equilibrium.converged());
    drawn.take(harness, equilibrium, space.components(place));
  }

  std::size_t measured = 0;
  for (const EnvelopeClearance& each : found) {
    if (each.other) continue;
    const std::size_t component = componentIndex(scene, each.component);
    const auto best = closest.toComponent(each.cable, component);
    ASSERT_TRUE(best) << each.component;
    EXPECT_LE(best->pair.distance, told.least({each.cable, component}) + 1e-7) << each.component;
    EXPECT_LE(each.worst_sample, best->pair.distance) << each.component;
    EXPECT_LE(each.distance, each.worst_sample) << each.component;
    // solved again, it is as close as it says
    Distances again{scene, parts, {}};
    again.take(best->solved->harness, best->solved->equilibrium, best->solved->components);
    EXPECT_NEAR(again.least({each.cable, component}), best->pair.distance, 1e-7) << each.component;
    std::size_t closer = 0;
    for (const double other : drawn.all[{each.cable, component}]) closer += other < each.worst_sample ? 1 : 0;
    EXPECT_LE(closer, 3U) << each.component;  // thousands were looked at: of 300 others hardly one is closer
    ++measured;
  }
  EXPECT_GE(measured, 4U);
}

}  // namespace
}  // namespace cable_variation::test
