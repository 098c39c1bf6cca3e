#pragma once  // internal to report/

#include <string>
#include <vector>

#include <cable_variation/report/section.h>
#include <cable_variation/scene/scene.h>

namespace cable_variation {

/// "turn of clip WH_Start about its y axis": what a design variable changes.
std::string targetText(const Scene& scene, const DesignTarget& target);

/// "normal, limits at 3 σ": how production spreads it.
std::string distributionText(const DesignVariable& variable);

/// What production varies: nominal value, tolerance and distribution of each of `variables` (indices).
/// @param values of the design, as StabilityOptions::values
ReportTable toleranceTable(const Scene& scene, const std::vector<std::size_t>& variables,
                           const DesignValues& values);

/// Regions and correlations among `variables`, a sentence each.
std::vector<std::string> toleranceNotes(const Scene& scene, const std::vector<std::size_t>& variables);

}  // namespace cable_variation
