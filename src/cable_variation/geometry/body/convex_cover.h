#pragma once

#include <vector>

#include <cable_variation/geometry/body/convex_hull.h>

namespace cable_variation {

/// The convex polyhedron about a union of bodies, and how far its vertices and the middles of its facets are
/// from the closest of them at most [m]. Balls become polyhedra of 42 corners that hold them.
struct ConvexCover {
  ConvexHull hull;
  double excess = 0.0;
};

/// Throws std::invalid_argument without bodies.
ConvexCover convexCover(const std::vector<const RoundedHull*>& bodies);

/// What merging alone adds, balls left round: the largest distance of the middles of facets of the cores'
/// common hull from the closest of the cores [m]. Quick, to choose by what to merge.
double mergingExcess(const std::vector<const RoundedHull*>& bodies);

}  // namespace cable_variation
