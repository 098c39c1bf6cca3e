#pragma once

#include <vector>

#include <cable_variation/measures/measure_evaluation.h>
#include <cable_variation/report/section.h>

namespace cable_variation {

/// Its tables: the cables' shapes, and the reactions of clips and joints.
std::vector<ReportTable> equilibriumTables(const SolvedScene& solved);

/// The chapter of a report on the design at rest: shapes, reactions of clips and joints, how sure the figures
/// are; force, moment, curvature and bend radius along each cable. Lengths in mm.
/// Deviations from planned routes too.
/// @param solved converged @param measures indices, with their values at `solved`
ReportSection equilibriumSection(const Scene& scene, const SolvedScene& solved,
                                 const std::vector<std::size_t>& measures,
                                 const std::vector<MeasureValue>& values);

}  // namespace cable_variation
