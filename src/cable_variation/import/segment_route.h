#pragma once

#include <vector>

#include <Eigen/Core>

#include <cable_variation/import/segment_curve.h>

namespace cable_variation {

/// The way of a segment as points, straight from one to the next: as few as stay within `tolerance` [m] of
/// the curve's samples, from its start to its end; two at least, no two neighbours the same.
std::vector<Eigen::Vector3d> routePoints(const SegmentCurve& curve, double tolerance);

}  // namespace cable_variation
