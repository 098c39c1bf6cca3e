#pragma once  // internal to equilibrium/

#include <optional>
#include <vector>

#include <cable_variation/equilibrium/discretisation/configuration.h>

namespace cable_variation {

/// Where a guide curve between two held places of a cable bulges, or whether it takes its stress-free form,
/// and by how many extra turns it is twisted.
struct Routing {
  enum class Bulge { natural, down, up, left, right, stress_free };
  Bulge bulge = Bulge::natural;
  int turns = 0;
};

/// A piece of cable between two neighbouring places whose position is held.
struct Interval {
  std::size_t cable = 0;
  double start = 0.0, end = 0.0;  ///< arc lengths [m]
  bool twistable = false;         ///< both ends hold the roll
  bool hinted = false;            ///< the cable has via or twist hints
  bool preformed = false;         ///< the cable has a rest curvature
};

/// Guide curves from nothing but the scene: cubic curves of the right length
/// through the held places along the held tangents, frames by parallel
/// transport with the twist spread evenly. Cables that hang on others come
/// after them; where nothing is held the cable goes on free of stress.
class InitialShape {
 public:
  InitialShape(const Harness& harness, const Topology& topology);

  const std::vector<Interval>& intervals() const { return intervals_; }

  /// One routing per interval. `arc_lengths` of the stations [m]; empty: as the topology has them.
  Configuration make(const Grid& grid, const std::vector<Routing>& routing,
                     const std::vector<double>& arc_lengths = {}) const;

 private:
  const Harness& harness_;
  const Topology& topology_;
  bool isAnchor(std::size_t station) const;

  std::vector<std::optional<Eigen::Vector3d>> meeting_points_;  // per station
  std::vector<Interval> intervals_;
  std::vector<std::size_t> cable_order_;
};

}  // namespace cable_variation
