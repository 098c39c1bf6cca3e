#pragma once

#include <cable_variation/MeasureInfo.h>
#include <cable_variation/MeasureResult.h>

#include <cable_variation/measures/measure_evaluation.h>
#include <cable_variation/scene/scene.h>

namespace cable_variation_ros {

cable_variation::MeasureInfo toInfo(const cable_variation::Measure& measure,
                                    const cable_variation::Scene& scene);

/// Whether `value` is within the limits that the measure has.
bool withinLimits(const cable_variation::Measure& measure, double value);

cable_variation::MeasureResult toResult(const cable_variation::Measure& measure,
                                        const cable_variation::MeasureValue& value,
                                        const cable_variation::Scene& scene);

}  // namespace cable_variation_ros
