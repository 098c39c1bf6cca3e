#pragma once  // internal to measures/

#include <cable_variation/measures/measure_context.h>

namespace cable_variation {

/// contact_force, contact_length: of the cable that a component presses hardest, or that touches it furthest,
/// found where its longest or hardest pressed stretch is; 0 and nowhere without one.
MeasureValue contactValue(const MeasureContext& context, const Measure& measure);
/// Of contact_force: places that press stay, and no others come.
double contactForceRate(const MeasureContext& context, const Measure& measure, const MeasureValue& value,
                        const MeasureRates& rates);

}  // namespace cable_variation
