#pragma once

#include <optional>

#include <cable_variation/envelope/clearance/envelope_clearance.h>

namespace cable_variation {

/// Whether a distance measure of the scene is between the two things of a clearance.
bool isOf(const Measure& measure, const EnvelopeClearance& clearance, const Scene& scene);

/// The lower limit [m] that the scene's distance measures set for a cable and a component, or two cables: the
/// largest, none without such a measure.
std::optional<double> lowerLimit(const Scene& scene, const EnvelopeClearance& clearance);

}  // namespace cable_variation
