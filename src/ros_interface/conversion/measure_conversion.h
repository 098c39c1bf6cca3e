#pragma once

#include <cable_variation/MeasureInfo.h>
#include <cable_variation/MeasureResult.h>

#include <cable_variation/measures/measure_evaluation.h>
#include <cable_variation/scene/scene.h>

namespace cable_variation_ros {

/// What all messages say of a measure.
template <typename Message>
Message described(const cable_variation::Measure& measure) {
  Message message;
  message.name = measure.name;
  message.type = toString(measure.type);
  message.unit = measure.unit;
  message.has_lower = measure.lower.has_value();
  message.lower = measure.lower.value_or(0.0);
  message.has_upper = measure.upper.has_value();
  message.upper = measure.upper.value_or(0.0);
  return message;
}

cable_variation::MeasureInfo toInfo(const cable_variation::Measure& measure,
                                    const cable_variation::Scene& scene);

cable_variation::MeasureResult toResult(const cable_variation::Measure& measure,
                                        const cable_variation::MeasureValue& value,
                                        const cable_variation::Scene& scene);

}  // namespace cable_variation_ros
