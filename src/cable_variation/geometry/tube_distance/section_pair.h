#pragma once  // internal to geometry/

#include <optional>

#include <cable_variation/geometry/tube_distance/tube_section.h>

namespace cable_variation {

/// Where two sections of tubes come closest.
struct PairMinimum {
  double value = 0.0;         ///< distance of the centrelines less both radii [m]
  double u = 0.0, v = 0.0;    ///< on the first, on the second
  Eigen::Vector3d direction;  ///< unit, from the second to the first; crossing: normal to both
  double distance = 0.0;      ///< of the centrelines [m]
};

/// Which pairs of places count: those whose way through a joint is long enough. The way is
/// first_start + u first_slope + second_start + v second_slope [m], at least `shortest`.
struct WayCondition {
  double first_start = 0.0, first_slope = 0.0;
  double second_start = 0.0, second_slope = 0.0;
  double shortest = -1.0;  ///< with all else 0: all pairs count

  double excess(double u, double v) const {
    return first_start + u * first_slope + second_start + v * second_slope - shortest;
  }
};

PairMinimum valueAt(const TubeSection& first, const TubeSection& second, double u, double v);

/// The smallest value over the pairs of places that count, to 1e-8 m; none if it is `cutoff` or more.
///
/// Branch and bound: for any unit vector n, n·(a - b) bounds the distance of a and b from below, a polynomial
/// for each section; a local minimum's n makes it sharp, and the condition's multiplier where that is active.
std::optional<PairMinimum> smallest(const TubeSection& first, const TubeSection& second,
                                    const WayCondition& condition, double cutoff);

}  // namespace cable_variation
