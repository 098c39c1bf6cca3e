#pragma once

#include <cable_variation/geometry/tube_distance/centreline.h>

namespace cable_variation {

/// The largest distance from a place of either curve to the other curve.
struct Hausdorff {
  double distance = 0.0;      ///< [m]
  double error_bound = 0.0;   ///< the true value lies within [distance, distance + error_bound] [m]
  bool on_first = true;       ///< the place is on the first curve
  Centreline::Place place;    ///< that is furthest from the other
  Centreline::Place nearest;  ///< on the other, closest to it
  bool unique = true;         ///< false: the place has two closest ones, and moves when the curves do
};

/// Two-sided Hausdorff distance between two centrelines, to `accuracy` [m].
Hausdorff curveHausdorff(const Centreline& a, const Centreline& b, double accuracy = 1e-7);

/// Two-sided Hausdorff distance between the surfaces of two tubes (mantle and
/// round ends: all points at the radius from the centreline), to `accuracy` [m]:
/// the largest of a place's distance to the other centreline, plus the radius here, minus
/// the radius there. The surface's furthest point lies straight beyond that place.
/// Where the other centreline has a kink of angle α on that side, or is bent tighter than radius
/// and distance together, the point is closer than that: the value is then too
/// large, by about radius × α² / 8 at a kink.
Hausdorff surfaceHausdorff(const Centreline& a, const Centreline& b, double accuracy = 1e-6);

}  // namespace cable_variation
