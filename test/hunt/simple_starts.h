#pragma once

#include <optional>
#include <string>

#include <hunt/discrete_rod.h>

namespace cable_variation::hunt {

/// What simple starts lead the independent rod to.
struct StartsResult {
  std::optional<DiscreteShape> lowest;  ///< of the stable shapes that cables bear
  DiscreteRod::Energy energy;           ///< of it
  int stable = 0;                       ///< how many starts ended in such a shape
  int stretched = 0;                    ///< ended stable, but stretched by more than cables bear
  int compressed = 0;                   ///< likewise
};

/// `count` starts, of six four with the least twist and one each with a turn more and less; every other one
/// with sliding clips anywhere.
StartsResult trySimpleStarts(const DiscreteRod& rod, int count, std::uint64_t seed);

/// Whether a finer grid has the shape too, stable and with about that energy: else it is the coarse grid's
/// alone.
bool isConfirmed(const DiscreteRod& rod, const DiscreteShape& shape);

/// Where sliding clips are, for a person: with that as their start a solver may find the shape.
std::string slidTo(const DiscreteRod& rod, const DiscreteShape& shape);

}  // namespace cable_variation::hunt
