#pragma once

#include <cable_variation/SimulateVariation.h>

#include <ros_interface/context/solver_context.h>
#include <ros_interface/display/view_origin.h>
#include <ros_interface/markers/simulation_markers.h>
#include <ros_interface/node/output_directory.h>
#include <ros_interface/runs/simulation_task.h>

namespace cable_variation_ros {

struct SimulationResult {
  cable_variation::SimulateVariationResponse response;
  SimulationView view;  ///< no markers: too few samples to show how cables vary
  ViewOrigin origin;
};

/// A simulation with its files and what is to be seen of it; touches nothing but the files. Its status is
/// CANCELLED when the observer ended it and IO_ERROR when a file could not be written, with all the figures
/// of what was done. Throws what simulateVariation() does, and cable_variation::FileError for files
/// that cannot even be begun.
SimulationResult calculateSimulation(const SimulationTask& task, const SolverContext::Snapshot& snapshot,
                                     const cable_variation::MeasureEvaluator& evaluator,
                                     const OutputDirectory& output,
                                     const cable_variation::SimulationObserver& observer);

}  // namespace cable_variation_ros
