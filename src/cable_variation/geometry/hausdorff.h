#pragma once

#include <cable_variation/geometry/centreline.h>

namespace cable_variation {

/// The largest distance from a place of either curve to the other curve.
struct Hausdorff {
  double distance = 0.0;      ///< [m]
  double error_bound = 0.0;   ///< the true value lies within [distance, distance + error_bound] [m]
  bool on_first = true;       ///< the place is on the first curve
  Centreline::Place place;    ///< that is furthest from the other
  Centreline::Place nearest;  ///< on the other, closest to it
};

/// Two-sided Hausdorff distance between two centrelines, to `accuracy` [m].
Hausdorff curveHausdorff(const Centreline& a, const Centreline& b, double accuracy = 1e-7);

/// Two-sided Hausdorff distance between the surfaces of two tubes (mantle and
/// round ends: all points at the radius from the centreline), to `accuracy` [m].
Hausdorff surfaceHausdorff(const Centreline& a, const Centreline& b, double accuracy = 1e-6);

}  // namespace cable_variation
