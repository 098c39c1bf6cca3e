// What an envelope's search takes, as estimated from one shape, beside what the process has grown by.
#include <cable_variation/envelope/envelope_memory.h>

#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <fstream>
#include <string>

#include <gtest/gtest.h>

#include <cable_variation/envelope/clearance/envelope_clearance.h>
#include <cable_variation/envelope/envelope_generator.h>
#include <cable_variation/scene_file/scene_reader.h>
#include <cable_variation/tracking/material_stretch.h>

#include "envelope_scenes.h"

namespace cable_variation::test {
namespace {

// The estimate is an upper bound, and of no more than so many times what is taken.
constexpr double kAtMost = 3.0;

double residentMemory() {
  std::ifstream file("/proc/self/statm");
  double all = 0.0, resident = 0.0;
  file >> all >> resident;
  return resident * static_cast<double>(sysconf(_SC_PAGESIZE));
}

Scene shipped(const std::string& name) {
  const std::string root = CABLE_VARIATION_SOURCE_DIR;
  return readScene(root + "/config/" + name + ".yaml", [&](const std::string&) { return root; });
}

EnvelopeOptions searchOnly(std::size_t variables) {
  EnvelopeOptions options;
  options.variables = allOf(variables);
  options.conservative = false;
  options.verification = 0;
  return options;
}

// As the generator has it: stretches of twice the thinnest radius.
EnvelopeMemory memoryOf(const Scene& scene, const EnvelopeOptions& options) {
  const SampleSpace space(scene, options);
  EquilibriumSolver solver = solverOf(scene);
  const SamplePlace start = space.designAt(options.from);
  const Harness harness = space.harness(start);
  const Equilibrium equilibrium = solver.solve(harness);
  double thinnest = 1.0;
  for (const CableShape& shape : equilibrium.shapes) thinnest = std::min(thinnest, shape.radius);
  std::vector<MaterialStretch> stretches;
  for (std::size_t cable = 0; cable < harness.cables.size(); ++cable) {
    const auto own =
        cutIntoStretches(cable, CableView(harness.cables[cable], equilibrium.shapes[cable]), 2.0 * thinnest);
    stretches.insert(stretches.end(), own.begin(), own.end());
  }
  std::vector<std::string> frames{"world"};
  frames.insert(frames.end(), options.frames.begin(), options.frames.end());
  const StretchReader reader(space, stretches, frames);
  return {reader.readWithRates(start, harness, equilibrium, solver), equilibrium};
}

struct Grown {
  Envelope envelope;
  double memory = 0.0;  // [B]
};

Grown grownBy(const Scene& scene, const EnvelopeOptions& options) {
  EquilibriumSolver solver = solverOf(scene);
  if (!solver.solve(scene.harness).converged()) throw std::runtime_error("not solved");
  const double before = residentMemory();
  std::atomic<double> most{before};
  Grown grown;
  grown.envelope = generateEnvelope(scene, options, solver, [&](const Progress&) {
    most = std::max(most.load(), residentMemory());
    return true;
  });
  grown.memory = most - before;
  return grown;
}

void expectBound(const char* name, double estimate, double grown) {
  constexpr double kRounding = 4e6;  // pages and arenas of a process that has just begun
  EXPECT_LE(grown, estimate + kRounding) << name;
  EXPECT_LE(estimate, kAtMost * grown + kRounding) << name;
}

// Snaps among them, and seen from three frames.
TEST(envelope_memory, of_the_search_of_a_harness_is_an_upper_bound) {
  const Scene scene = shipped("harness");
  EnvelopeOptions options = searchOnly(10);
  options.frames = clearanceFrames(scene, options);
  options.largest_solves = 1200;
  options.threads = 1;
  const EnvelopeMemory memory = memoryOf(scene, options);
  const Grown grown = grownBy(scene, options);
  EXPECT_GT(grown.envelope.samples.size(), 300U);
  expectBound("harness", memory.ofSearch(grown.envelope.samples.size(), 8), grown.memory);
}

TEST(envelope_memory, of_the_phases_of_a_motion_is_an_upper_bound) {
  const Scene scene = shipped("hose");
  EnvelopeOptions options = searchOnly(3);
  options.motions = {0};
  options.to = 2.0;
  options.frames = clearanceFrames(scene, options);
  options.threads = 1;
  const EnvelopeMemory memory = memoryOf(scene, options);
  const Grown grown = grownBy(scene, options);
  const auto phases = static_cast<double>(grown.envelope.phases.size());
  expectBound("hose",
              phases * memory.phase + memory.shape * static_cast<double>(grown.envelope.samples.size()),
              grown.memory);
}

// With little memory the search keeps fewer shapes, says so, and still answers.
TEST(envelope_memory, a_search_keeps_no_more_shapes_than_it_is_enough_for) {
  const Scene scene = shipped("harness");
  EnvelopeOptions options = searchOnly(10);
  options.threads = 1;
  const EnvelopeMemory memory = memoryOf(scene, options);
  options.memory_limit = 1e7;
  while (memory.mostShapes(options.memory_limit, 1) <= 50) options.memory_limit *= 1.2;
  const std::size_t most = memory.mostShapes(options.memory_limit, 1);
  ASSERT_GT(most, 50U);
  ASSERT_LT(most, 200U);
  const Grown grown = grownBy(scene, options);
  EXPECT_LT(grown.envelope.samples.size(), 2 * most + 128);  // a round of solves further at most
  ASSERT_FALSE(grown.envelope.warnings.empty());
  EXPECT_NE(grown.envelope.warnings[0].find("memory is enough for"), std::string::npos);
}

// One phase has one search, however many threads there are.
TEST(envelope_memory, threads_without_a_search_leave_their_share) {
  const Scene scene = shipped("harness");
  EnvelopeOptions options = searchOnly(10);
  options.frames = clearanceFrames(scene, options);
  const EnvelopeMemory memory = memoryOf(scene, options);
  // by default half of the 2 GB of the node are for it: enough for the 3000 solves, and for what snaps add
  EXPECT_GT(memory.mostShapes(1e9, 1), 3500U);
  EXPECT_LE(memory.mostShapes(1e9, 1000), memory.mostShapes(1e9, 1) / 2);
}

}  // namespace
}  // namespace cable_variation::test
