#pragma once

#include <cable_variation/AnalyzeStability.h>

#include <cable_variation/sensitivity/component_variation.h>
#include <cable_variation/sensitivity/stability_analysis.h>

namespace cable_variation_ros {

/// Everything but the status, what is shown, and files.
/// @param values the design analysed, as in StabilityOptions
cable_variation::AnalyzeStabilityResponse toResponse(
    const cable_variation::Scene& scene, const cable_variation::DesignValues& values,
    const cable_variation::StabilityAnalysis& analysis,
    const std::vector<cable_variation::ComponentVariation>& components,
    const cable_variation::ComponentPoses& poses);

}  // namespace cable_variation_ros
