#pragma once

#include <string>
#include <vector>

#include <cable_variation/report/envelope_section.h>
#include <cable_variation/analysis/design_snapshot.h>
#include <cable_variation/analysis/envelope_task.h>

namespace cable_variation {

/// The page on an envelope; solves its design once more, and measures it.
/// @param solver the design's shape to follow @param warnings of the answer
std::string envelopeReport(const EnvelopeTask& task, const DesignSnapshot& snapshot,
                           const EquilibriumSolver& solver, const EnvelopeFindings& found,
                           const std::vector<std::string>& warnings);

}  // namespace cable_variation
