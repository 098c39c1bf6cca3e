#pragma once

#include <vector>

#include <cable_variation/harness/configuration.h>

namespace cable_variation {

/// Where a guide curve between two held places of a cable bulges, and by how
/// many extra turns it is twisted.
struct Routing {
  enum class Bulge { natural, down, up, left, right };
  Bulge bulge = Bulge::natural;
  int turns = 0;
};

/// A piece of cable between two neighbouring places whose position is held.
struct Interval {
  std::size_t cable = 0;
  double start = 0.0, end = 0.0;  ///< arc lengths [m]
  bool twistable = false;         ///< both ends hold the roll
  bool hinted = false;            ///< the cable has via or twist hints
};

/// Guide curves from nothing but the scene: cubic curves of the right length
/// through the held places along the held tangents, frames by parallel
/// transport with the twist spread evenly. Cables that hang on others come
/// after them; where nothing is held the cable goes on straight.
class InitialShape {
 public:
  InitialShape(const Harness& harness, const Topology& topology);

  const std::vector<Interval>& intervals() const { return intervals_; }

  /// One routing per interval.
  Configuration make(const Grid& grid, const std::vector<Routing>& routing) const;

 private:
  const Harness& harness_;
  const Topology& topology_;
  std::vector<Interval> intervals_;
  std::vector<std::size_t> cable_order_;
};

}  // namespace cable_variation
