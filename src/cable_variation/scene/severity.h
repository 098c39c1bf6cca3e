#pragma once

#include <cable_variation/scene/measure.h>

namespace cable_variation {

/// Severity of a measure's value, larger is worse: by how much it is beyond its nearest limit; without limits
/// by MeasureTraits::Worse: a small distance, a position far from `nominal`, a large magnitude.
double severity(const Measure& measure, double nominal, double value);

/// Whether `value` is worse than `than`; anything is worse than what is not a number, that is never worse.
bool isWorse(const Measure& measure, double nominal, double value, double than);

}  // namespace cable_variation
