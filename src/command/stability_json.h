#pragma once

#include <vector>

#include <cable_variation/sensitivity/component_variation.h>
#include <cable_variation/sensitivity/stability_analysis.h>
#include <command/json.h>

namespace cable_variation_command {

/// As AnalyzeStability answers it, but for status, files and what RViz shows.
/// @param options that it was made with @param components that vary by themselves
Json stabilityJson(const cable_variation::Scene& scene, const cable_variation::StabilityOptions& options,
                   const cable_variation::StabilityAnalysis& analysis,
                   const std::vector<cable_variation::ComponentVariation>& components);

}  // namespace cable_variation_command
