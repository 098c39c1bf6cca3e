#pragma once

#include <cstddef>
#include <optional>

#include <cable_variation/geometry/tube_distance/distance.h>
#include <cable_variation/harness/harness.h>

namespace cable_variation {

/// Where one cable hangs on another.
struct JointBetween {
  std::size_t joint = 0;  ///< index into Harness::joints
  bool parent_first = false;
  double on_first = 0.0, on_second = 0.0;  ///< arc lengths [m]

  /// For the distance of the first cable from the second.
  JoinedAt at(double shortest_way) const { return {on_first, on_second, shortest_way}; }
};

/// The first joint between two cables, whichever is the parent.
std::optional<JointBetween> jointBetween(const Harness& harness, std::size_t first, std::size_t second);

/// Where two cables hang together, directly or by others between them: by the shortest way along those, which
/// is taken off `shortest_way` [m]. None if they do not, or if that way alone is as long.
std::optional<JoinedAt> joinedAlong(const Harness& harness, std::size_t first, std::size_t second,
                                    double shortest_way);

}  // namespace cable_variation
