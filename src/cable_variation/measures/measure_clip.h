#pragma once  // internal to measures/

#include <cable_variation/measures/measure_context.h>

namespace cable_variation {

// What a clip does to the cable it holds.

/// clip_force, clip_moment: the reaction's magnitude, or its component along an axis of the clip.
MeasureValue clipLoadValue(const MeasureContext& context, const Measure& measure);
double clipLoadRate(const MeasureContext& context, const Measure& measure, const MeasureRates& rates);

/// Arc length held now, minus the one where the scene puts the clip.
MeasureValue slideValue(const MeasureContext& context, const Measure& measure);
double slideRate(const Measure& measure, const MeasureRates& rates);

}  // namespace cable_variation
