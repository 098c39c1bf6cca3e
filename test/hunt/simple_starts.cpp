#include <hunt/simple_starts.h>

#include <cmath>

#include <hunt/discrete_minimise.h>
#include <hunt/discrete_start.h>
#include <hunt/scales.h>

namespace cable_variation::hunt {
namespace {

// More stretch than this no real cable bears.
constexpr double kLargestStretch = 0.05;
// A clip that slid nearer than this share of its cable to whatever is next has slid out of its room.
constexpr double kSmallestRoom = 0.01;

}  // namespace

StartsResult trySimpleStarts(const DiscreteRod& rod, int count, std::uint64_t seed) {
  constexpr std::uint32_t kStream = 1000;  // beside those of the families
  StartsResult result;
  for (int i = 0; i < count; ++i) {
    Draw draw(seed, kStream, static_cast<std::uint64_t>(i));
    const int turns = i % 6 == 2 ? 1 : i % 6 == 4 ? -1 : 0;
    DiscreteShape shape = simpleStart(rod, draw, i % 2 == 1, turns);
    if (!descend(rod, shape).stable) continue;
    double sign = 0.0;
    if (rod.largestStretch(shape, &sign) > kLargestStretch) {
      ++(sign > 0.0 ? result.stretched : result.compressed);
      continue;
    }
    if (rod.smallestRoom(shape) < kSmallestRoom) continue;
    ++result.stable;
    const DiscreteRod::Energy energy = rod.energy(shape);
    if (result.lowest && energy.total() >= result.energy.total()) continue;
    result.lowest = std::move(shape);
    result.energy = energy;
  }
  return result;
}

bool isConfirmed(const DiscreteRod& rod, const DiscreteShape& shape) {
  const DiscreteRod finer(rod.harness(), halved(rod.layout()));
  DiscreteShape there = onHalved(rod.layout(), shape);
  if (!settle(finer, there).stable) {
    there = onHalved(rod.layout(), shape);
    if (!descend(finer, there).stable) return false;
  }
  if (finer.largestStretch(there) > kLargestStretch) return false;
  if (finer.smallestRoom(there) < kSmallestRoom) return false;
  const DiscreteRod::Energy coarse = rod.energy(shape), fine = finer.energy(there);
  const double scale = std::max(coarse.elastic() + coarse.springs, bendingScale(rod.harness()));
  return std::abs(coarse.total() - fine.total()) < 0.1 * scale;
}

std::string slidTo(const DiscreteRod& rod, const DiscreteShape& shape) {
  std::string text;
  for (std::size_t i = 0; i < rod.layout().clip_station.size(); ++i) {
    const std::size_t station = rod.layout().clip_station[i];
    if (!rod.slides(station)) continue;
    const std::string& name = rod.harness().clips[i].name;
    text += textOf(", '", name, "' at ", 1e3 * shape.stations[station].arc_length, " mm");
  }
  return text;
}

}  // namespace cable_variation::hunt
