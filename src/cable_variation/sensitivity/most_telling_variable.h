#pragma once

#include <optional>

#include <cable_variation/scene/scene.h>
#include <cable_variation/sensitivity/stability_analysis.h>

namespace cable_variation {

/// The variable worth looking at first, a column of the analysis: the one with
/// the largest share in the measure that has the least margin to its limits, in
/// standard deviations. Where no measure with limits varies: the one that
/// shifts the cables most at its limits. None if there are no variables.
std::optional<std::size_t> mostTellingVariable(const Scene& scene, const StabilityAnalysis& analysis);

}  // namespace cable_variation
