#pragma once

#include <string>
#include <vector>

#include <cable_variation/report/envelope_section.h>
#include <ros_interface/context/solver_context.h>
#include <ros_interface/runs/envelope_task.h>

namespace cable_variation_ros {

/// The page on an envelope; solves its design once more, and measures it.
/// @param solver the design's shape to follow @param warnings of the answer
std::string envelopeReport(const EnvelopeTask& task, const SolverContext::Snapshot& snapshot,
                           const cable_variation::EquilibriumSolver& solver,
                           const cable_variation::EnvelopeFindings& found,
                           const std::vector<std::string>& warnings);

}  // namespace cable_variation_ros
