#pragma once

#include <cable_variation/report/section.h>
#include <cable_variation/scene/scene.h>
#include <cable_variation/sensitivity/stability_analysis.h>

namespace cable_variation {

/// In its SI unit, of the design analysed.
double nominalValue(const DesignVariable& variable, const DesignValues& values);

// The tables of a stability analysis that has converged.
ReportTable measureTable(const Scene& scene, const StabilityAnalysis& analysis);
ReportTable spreadTable(const Scene& scene, const StabilityAnalysis& analysis);
ReportTable sensitivityTable(const Scene& scene, const StabilityAnalysis& analysis);
ReportTable variableTable(const Scene& scene, const StabilityAnalysis& analysis, const DesignValues& values);

}  // namespace cable_variation
