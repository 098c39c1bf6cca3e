#pragma once  // internal to measures/

#include <cable_variation/measures/measure_context.h>

namespace cable_variation {

/// D_SIM: the largest two-sided Hausdorff distance of a cable to itself in the
/// nominal shape, of centrelines or surfaces. @param nominal per cable
MeasureValue similarityValue(const MeasureContext& context, const Measure& measure,
                             const std::vector<Centreline>& nominal);

/// At the nominal shape itself, where the measure is zero and has a kink, the one-sided limit of it over a
/// small change, the same for both directions: the largest shift across the curve, and of the ends along it
/// too; of surfaces, with the change of the radius.
RateOfMeasure similarityRate(const MeasureContext& context, const Measure& measure,
                             const MeasureValue& value);

}  // namespace cable_variation
