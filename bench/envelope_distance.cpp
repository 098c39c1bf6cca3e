// Distances of envelopes: bodies of a cable's stretches beside a part of 133,000 triangles, at rest and over
// the 30 phases of a motion, and against those of another cable.

#include <benchmark/benchmark.h>

#include <cmath>
#include <memory>
#include <random>
#include <vector>

#include <cable_variation/geometry/body/body_distance.h>

#include "ring.h"

namespace cable_variation::bench {
namespace {

constexpr double kRadius = 0.004, kStretch = 0.008;  // [m]

const DistancePart& part() {
  static const DistancePart prepared{ring(443, 150)};
  return prepared;
}

// Stretches one after another along x at a height over the ring's middle, each of shapes that are up to
// `swing` [m] apart, pushed aside by the phase.
std::vector<RoundedHull> envelope(std::size_t stretches, std::size_t phases, double height, double swing) {
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> place(-0.5, 0.5);
  std::vector<RoundedHull> bodies;
  for (std::size_t phase = 0; phase < phases; ++phase) {
    const double aside = 0.01 * std::sin(static_cast<double>(phase));
    for (std::size_t i = 0; i < stretches; ++i) {
      const double x = kStretch * (static_cast<double>(i) - 0.5 * static_cast<double>(stretches));
      std::vector<Eigen::Vector3d> points;
      for (int k = 0; k < 120; ++k) {
        points.emplace_back(x + kStretch * (place(random) + 0.5), height + aside + swing * place(random),
                            swing * place(random));
      }
      bodies.push_back({ConvexHull(points), kRadius});
    }
  }
  return bodies;
}

std::vector<const RoundedHull*> pointers(const std::vector<RoundedHull>& bodies) {
  std::vector<const RoundedHull*> all;
  for (const RoundedHull& body : bodies) all.push_back(&body);
  return all;
}

// Arguments: phases, height over the ring's outermost point [mm].
void toPart(benchmark::State& state) {
  const std::vector<RoundedHull> bodies =
      envelope(60, static_cast<std::size_t>(state.range(0)),
               kOutermost + 1e-3 * static_cast<double>(state.range(1)), 0.02);
  const std::vector<const RoundedHull*> all = pointers(bodies);
  const DistancePart& against = part();
  std::optional<BodyPair> pair;
  for (auto _ : state) {
    pair = distance(all, against, Pose());
    benchmark::DoNotOptimize(pair);
  }
  state.counters["distance_mm"] = 1e3 * pair->distance;
}

// The same, with the triangles that enter.
void enteringPart(benchmark::State& state) {
  const std::vector<RoundedHull> bodies =
      envelope(60, static_cast<std::size_t>(state.range(0)),
               kOutermost + 1e-3 * static_cast<double>(state.range(1)), 0.02);
  const std::vector<const RoundedHull*> all = pointers(bodies);
  const DistancePart& against = part();
  std::size_t entering = 0;
  for (auto _ : state) entering = enteringTriangles(all, against, Pose()).size();
  state.counters["triangles"] = static_cast<double>(entering);
}

// Argument: phases; two cables beside each other, 60 stretches and 15.
void betweenCables(benchmark::State& state) {
  const auto phases = static_cast<std::size_t>(state.range(0));
  const std::vector<RoundedHull> first = envelope(60, phases, 0.0, 0.02),
                                 second = envelope(15, phases, 0.04, 0.02);
  std::vector<BodyCouple> couples;
  for (std::size_t phase = 0; phase < phases; ++phase) {
    for (std::size_t i = 0; i < 60; ++i) {
      for (std::size_t k = 0; k < 15; ++k)
        couples.emplace_back(&first[60 * phase + i], &second[15 * phase + k]);
    }
  }
  std::optional<BodyPair> pair;
  for (auto _ : state) {
    pair = distance(couples);
    benchmark::DoNotOptimize(pair);
  }
  state.counters["distance_mm"] = 1e3 * pair->distance;
}

BENCHMARK(toPart)->ArgsProduct({{1, 30}, {40, 20, 10, 0}})->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(enteringPart)->ArgsProduct({{1, 30}, {10, 0}})->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(betweenCables)->Arg(1)->Arg(30)->Unit(benchmark::kMillisecond)->UseRealTime();

}  // namespace
}  // namespace cable_variation::bench

BENCHMARK_MAIN();
