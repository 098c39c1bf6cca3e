// Distances: a bent cable of 312 mm in 100 pieces, at some millimetres to some tens of them from a part of
// 50,000 triangles; beside it FCL's own way as a yardstick, the centreline as degenerate triangles.

#include <benchmark/benchmark.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <memory>
#include <stdexcept>
#include <vector>

#include <cable_variation/geometry/mesh/fcl_model.h>
#include <cable_variation/geometry/tube_distance/distance.h>

#include "fcl_distance.h"
#include "ring.h"

namespace cable_variation::bench {
namespace {

constexpr double kLength = 0.312, kRadius = 0.004, kCurvature = 5.0;  // [m], [m], [1/m]
constexpr int kPieces = 100;

// An arc in the x-y plane with a wave across it, its middle at `height` along y.
Centreline bentCable(double height, double curvature = kCurvature) {
  constexpr double wave = 0.02, waves = 10.0;  // [m], [1/m]
  const auto end = [&](double s) {
    const double a = curvature * (s - 0.5 * kLength), w = waves * s;
    return CurvePiece::End{
        {std::sin(a) / curvature, height + (1.0 - std::cos(a)) / curvature, wave * std::sin(w)},
        {std::cos(a), std::sin(a), wave * waves * std::cos(w)},
        {-curvature * std::sin(a), curvature * std::cos(a), -wave * waves * waves * std::sin(w)}};
  };
  Centreline cable;
  constexpr double h = kLength / kPieces;
  for (int i = 0; i < kPieces; ++i) {
    cable.pieces.push_back(
        {CurvePiece(end(i * h), end((i + 1) * h), h), i * h, (i + 1) * h, kRadius, kRadius});
  }
  return cable;
}

TriangleMesh ringOf50000() { return ring(250, 100); }

const DistancePart& part() {
  static const DistancePart prepared{ringOf50000()};
  return prepared;
}

// Of the same, every thousandth facet missing: told by its winding number.
const DistancePart& openPart() {
  static const DistancePart prepared = [] {
    TriangleMesh mesh = ringOf50000();
    std::vector<std::array<std::uint32_t, 3>> kept;
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
      if (i % 1000 != 500) kept.push_back(mesh.triangles[i]);
    }
    mesh.triangles = kept;
    return DistancePart(mesh);
  }();
  return prepared;
}

double heightAt(const benchmark::State& state) {
  return kOutermost + 1e-3 * static_cast<double>(state.range(0));
}

void report(benchmark::State& state, const ClosestPair& pair) {
  state.counters["distance_mm"] = 1e3 * pair.distance;
}

// Argument: how far the centreline's middle is from the ring [mm].
void toPart(benchmark::State& state) {
  const Centreline cable = bentCable(heightAt(state));
  const DistancePart& against = part();
  std::optional<ClosestPair> pair;
  for (auto _ : state) {
    pair = distance(cable, against, Pose());
    benchmark::DoNotOptimize(pair);
  }
  report(state, *pair);
}

// Shapes by turns that are 0.1 mm and a little curvature apart, each with the other's pair as a hint.
void toPartAgain(benchmark::State& state) {
  const double height = heightAt(state);
  const Centreline cables[] = {bentCable(height), bentCable(height + 1e-4, 1.002 * kCurvature)};
  const DistancePart& against = part();
  ClosestPair pair = *distance(cables[0], against, Pose());
  std::size_t i = 0;
  for (auto _ : state) {
    const ClosestPair hint = pair;
    pair = *distance(cables[++i % 2], against, Pose(), {}, 1e-5, {&hint});
    benchmark::DoNotOptimize(pair);
  }
  report(state, pair);
}

// Pieces as chords, each a triangle with two corners in the same place: no radius, no arcs between.
using Model = fcl::BVHModel<fcl_types::RectangleSweptSphere>;

std::shared_ptr<Model> model(const std::vector<Eigen::Vector3d>& vertices,
                             const std::vector<fcl::Triangle>& triangles) {
  auto made = std::make_shared<Model>();
  fill(*made, vertices, triangles);
  return made;
}

std::shared_ptr<Model> chords(const Centreline& cable) {
  std::vector<Eigen::Vector3d> vertices = {cable.position({0, 0.0})};
  std::vector<fcl::Triangle> triangles;
  for (std::size_t i = 0; i < cable.pieces.size(); ++i) {
    vertices.push_back(cable.position({i, 1.0}));
    triangles.emplace_back(i, i + 1, i + 1);
  }
  return model(vertices, triangles);
}

void toPartByFcl(benchmark::State& state) {
  const Centreline cable = bentCable(heightAt(state));
  const TriangleMesh mesh = ringOf50000();
  std::vector<fcl::Triangle> triangles;
  for (const auto& [a, b, c] : mesh.triangles) triangles.emplace_back(a, b, c);
  const fcl_types::Object against(model(mesh.vertices, triangles));
  fcl_types::DistanceResult result;
  for (auto _ : state) {
    const fcl_types::Object moved(chords(cable));
    result.clear();
    fcl::distance(&moved, &against, fcl_types::DistanceRequest(), result);
    benchmark::DoNotOptimize(result);
  }
  state.counters["distance_mm"] = 1e3 * (result.min_distance - kRadius);
}

// Centreline 200 mm, at the ring's own middle line: deep inside.
void withinPart(benchmark::State& state) {
  const Centreline cable = bentCable(0.18);
  const DistancePart& against = part();
  std::optional<ClosestPair> pair;
  for (auto _ : state) {
    pair = distance(cable, against, Pose());
    benchmark::DoNotOptimize(pair);
  }
  if (pair->contact != ClosestPair::Contact::pierced) throw std::runtime_error("the cable is not inside");
  report(state, *pair);
}

void toOpenPart(benchmark::State& state) {
  const Centreline cable = bentCable(heightAt(state));
  const DistancePart& against = openPart();
  std::optional<ClosestPair> pair;
  for (auto _ : state) {
    pair = distance(cable, against, Pose());
    benchmark::DoNotOptimize(pair);
  }
  if (pair->side != ClosestPair::Side::wound) throw std::runtime_error("the part is not open");
  report(state, *pair);
}

void withinOpenPart(benchmark::State& state) {
  const Centreline cable = bentCable(0.18);
  const DistancePart& against = openPart();
  std::optional<ClosestPair> pair;
  for (auto _ : state) {
    pair = distance(cable, against, Pose());
    benchmark::DoNotOptimize(pair);
  }
  if (!pair->is_depth) throw std::runtime_error("the cable is not inside");
  report(state, *pair);
}

void toCable(benchmark::State& state) {
  const Centreline cable = bentCable(0.0), other = bentCable(heightAt(state) - kOutermost, -kCurvature);
  std::optional<ClosestPair> pair;
  for (auto _ : state) {
    pair = distance(cable, other);
    benchmark::DoNotOptimize(pair);
  }
  report(state, *pair);
}

// Beside each other all along, as cables of one bundle are.
void toParallelCable(benchmark::State& state) {
  const double gap = 1e-3 * static_cast<double>(state.range(0));
  const Centreline cable = bentCable(0.0);
  Centreline other = cable;
  for (Centreline::Piece& piece : other.pieces) {
    const auto end = [&](double t) {
      return CurvePiece::End{piece.curve.position(t) + Eigen::Vector3d(0.0, 0.0, gap), piece.curve.first(t),
                             piece.curve.second(t)};
    };
    piece.curve = CurvePiece(end(0.0), end(1.0), 1.0);
  }
  std::optional<ClosestPair> pair;
  for (auto _ : state) {
    pair = distance(cable, other);
    benchmark::DoNotOptimize(pair);
  }
  report(state, *pair);
}

void preparePart(benchmark::State& state) {
  const TriangleMesh mesh = ringOf50000();
  for (auto _ : state) {
    DistancePart prepared(mesh);
    benchmark::DoNotOptimize(&prepared.impl());
  }
}

// As a damaged export has it: every corner with a vertex of its own, off by rounding.
void prepareWeldedPart(benchmark::State& state) {
  const TriangleMesh whole = ringOf50000();
  TriangleMesh mesh;
  for (const auto& triangle : whole.triangles) {
    const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
    for (const std::uint32_t vertex : triangle) {
      const double off = 1e-15 * static_cast<double>(mesh.vertices.size() % 7);
      mesh.vertices.push_back(whole.vertices[vertex] + Eigen::Vector3d(off, -off, off));
    }
    mesh.triangles.push_back({first, first + 1, first + 2});
  }
  for (auto _ : state) {
    DistancePart prepared(mesh);
    benchmark::DoNotOptimize(&prepared.impl());
  }
}

BENCHMARK(toPart)->Arg(5)->Arg(10)->Arg(20)->Arg(40)->Unit(benchmark::kMicrosecond);
BENCHMARK(toPartAgain)->Arg(5)->Arg(10)->Arg(20)->Arg(40)->Unit(benchmark::kMicrosecond);
BENCHMARK(toPartByFcl)->Arg(5)->Arg(10)->Arg(20)->Arg(40)->Unit(benchmark::kMicrosecond);
BENCHMARK(withinPart)->Unit(benchmark::kMicrosecond);
BENCHMARK(toOpenPart)->Arg(5)->Arg(40)->Unit(benchmark::kMicrosecond);
BENCHMARK(withinOpenPart)->Unit(benchmark::kMicrosecond);
BENCHMARK(toCable)->Arg(-20)->Arg(10)->Arg(40)->Unit(benchmark::kMicrosecond);
BENCHMARK(toParallelCable)->Arg(12)->Unit(benchmark::kMicrosecond);
BENCHMARK(preparePart)->Unit(benchmark::kMillisecond);
BENCHMARK(prepareWeldedPart)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace cable_variation::bench

BENCHMARK_MAIN();
