#pragma once  // internal to measures/

#include <cable_variation/geometry/tube_distance/hausdorff.h>
#include <cable_variation/measures/cable_view.h>

namespace cable_variation {

constexpr double kSameShape = 1e-9;  // [m] curves closer than that are one: rounding of a re-solve

/// curveHausdorff or surfaceHausdorff to 1e-6 m, of a small one to 1e-5 of itself, since derivatives are its
/// limit; nothing is found finer than it needs to be, for that takes long.
Hausdorff foundBy(Hausdorff (*distance)(const Centreline&, const Centreline&, double), const Centreline& a,
                  const Centreline& b);

/// How fast a stretch of a cable leaves a curve that it lies on, as a variable grows: the limit of their
/// two-sided Hausdorff distance over the step, the same for both signs. It is the largest shift across the
/// curve, at the stretch's ends the whole shift, and at a kink between pieces, at a clip whose force jumps,
/// the distance of the shifted corner to the two arms, or of the corner to the shifted arms.
/// @param start_shift, end_shift change of the position of the stretch's ends
/// @param radius change of the radius where surfaces are compared, the same all along; else 0
double leavingRate(const CableView& view, const CableRates& rates, const Place& start, const Place& end,
                   const Eigen::Vector3d& start_shift, const Eigen::Vector3d& end_shift, double radius);

}  // namespace cable_variation
