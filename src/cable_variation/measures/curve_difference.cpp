#include <cable_variation/measures/curve_difference.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include <cable_variation/math/extremum.h>

namespace cable_variation {
namespace {

using Eigen::Vector3d;

// How fast a place leaves the curve, seen across it.
double acrossRate(const CurvePiece& curve, double t, const Vector3d& shift) {
  const Vector3d along = curve.first(t);
  return (shift - shift.dot(along) / along.squaredNorm() * along).norm();
}

// At an end, or where the tangent has a kink. `arms`: unit directions in which the curve goes on. The curve
// is left by the shifted point, or it by the shifted curve.
double cornerRate(const std::vector<Vector3d>& arms, const Vector3d& shift, double radius_rate) {
  const auto distanceTo = [&](const Vector3d& point) {
    double smallest = point.norm();
    for (const Vector3d& arm : arms) {
      const double along = point.dot(arm);
      if (along > 0.0) smallest = std::min(smallest, (point - along * arm).norm());
    }
    return smallest;
  };
  return std::max(distanceTo(shift) + radius_rate, distanceTo(-shift) - radius_rate);
}

}  // namespace

Hausdorff foundBy(Hausdorff (*distance)(const Centreline&, const Centreline&, double), const Centreline& a,
                  const Centreline& b) {
  constexpr double kAccuracy = 1e-6, kShare = 1e-5, kFinest = 1e-9;
  const Hausdorff rough = distance(a, b, kAccuracy);
  const double accuracy = std::max(kFinest, kShare * rough.distance);
  return accuracy < kAccuracy ? distance(a, b, accuracy) : rough;
}

double leavingRate(const CableView& view, const CableRates& rates, const Place& start, const Place& end,
                   const Vector3d& start_shift, const Vector3d& end_shift, double radius) {
  const std::size_t pieces = end.piece + 1 - start.piece;
  std::vector<CurvePiece> shifts;
  shifts.reserve(pieces);
  for (std::size_t i = 0; i < pieces; ++i) shifts.push_back(view.curveRate(start.piece + i, rates));
  const auto curve = [&](std::size_t i) -> const CurvePiece& {
    return view.line().pieces[start.piece + i].curve;
  };
  const auto leaving = [&](std::size_t i, double share) {
    const double from = i == 0 ? start.t : 0.0, to = i + 1 == pieces ? end.t : 1.0;
    const double t = from + share * (to - from);
    return acrossRate(curve(i), t, shifts[i].position(t)) + std::abs(radius);
  };
  constexpr double kShare = 1e-4;  // of t: the maximum itself is then right to about 1e-8
  double largest = largestAlong<4>(pieces, leaving, kShare).value;
  largest = std::max(largest, cornerRate({curve(0).first(start.t).normalized()}, start_shift, radius));
  largest = std::max(largest, cornerRate({-curve(pieces - 1).first(end.t).normalized()}, end_shift, radius));
  for (std::size_t i = 1; i < pieces; ++i) {
    // two points at one arc length
    if (view.pieces()[start.piece + i - 1].point + 1 == view.pieces()[start.piece + i].point) continue;
    const std::vector<Vector3d> arms{-curve(i - 1).first(1.0).normalized(), curve(i).first(0.0).normalized()};
    largest = std::max(largest, cornerRate(arms, shifts[i].position(0.0), radius));
  }
  return largest;
}

}  // namespace cable_variation
