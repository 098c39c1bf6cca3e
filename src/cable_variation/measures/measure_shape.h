#pragma once  // internal to measures/

#include <cable_variation/measures/measure_context.h>

namespace cable_variation {

// Position of a section along a direction, and the smallest bend radius.

/// direction · φ(s).
MeasureValue positionValue(const MeasureContext& context, const Measure& measure);
double positionRate(const MeasureContext& context, const Measure& measure, const MeasureValue& value,
                    const MeasureRates& rates);

/// Smallest radius of curvature of the centrelines; infinite where all are straight.
MeasureValue bendRadiusValue(const MeasureContext& context, const Measure& measure);
double bendRadiusRate(const MeasureContext& context, const MeasureValue& value, const MeasureRates& rates);

}  // namespace cable_variation
