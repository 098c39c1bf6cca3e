#pragma once  // internal to measures/

#include <cable_variation/geometry/tube_distance/distance.h>
#include <cable_variation/measures/measure_context.h>

namespace cable_variation {

// Distance of cables to a component or to other cables, see geometry/distance.h.

/// Sections within Measure::skip_near_clips of a clip that rides on the component do not count.
/// @param bodies of the component @param near of a similar shape, or null
/// @param vicinities of each body, of each of the measure's cables, or none
MeasureValue componentDistanceValue(const MeasureContext& context, const Measure& measure,
                                    const std::vector<MeasuredBody>& bodies, const MeasureValue* near,
                                    const std::vector<PartVicinity>& vicinities);
double componentDistanceRate(const MeasureContext& context, const Measure& measure, const MeasureValue& value,
                             const MeasureRates& rates);

/// Pairs of sections of two joined cables count only when the way from one to the other through the joint
/// is at least Measure::skip_near_joints.
MeasureValue cableDistanceValue(const MeasureContext& context, const Measure& measure);
double cableDistanceRate(const MeasureContext& context, const Measure& measure, const MeasureValue& value,
                         const MeasureRates& rates);

}  // namespace cable_variation
