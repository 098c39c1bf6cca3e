#pragma once  // internal to measures/

#include <cable_variation/measures/measure_functions.h>

namespace cable_variation {

// How far a cable is from the route that was planned for it.

/// Two-sided Hausdorff distance between the centreline from `from` to `to` and the route's polyline: no place
/// of the stretch is further from the route, no place of the route further from the stretch. `point` is on
/// the cable, `other` on the route.
MeasureValue routeDeviationValue(const MeasureContext& context, const Measure& measure);

/// Its derivatives; where the stretch lies on its route, the limit for both signs of the variable.
RateOfMeasure routeDeviationRate(const MeasureContext& context, const Measure& measure,
                                 const MeasureValue& value);

}  // namespace cable_variation
