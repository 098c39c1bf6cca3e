#pragma once

#include <string>

#include <cable_variation/analysis/answer_status.h>
#include <cable_variation/analysis/design_snapshot.h>
#include <cable_variation/analysis/output_directory.h>
#include <cable_variation/analysis/run_control.h>
#include <cable_variation/analysis/simulation_files.h>
#include <cable_variation/analysis/simulation_task.h>
#include <cable_variation/measures/measure_evaluation.h>

namespace cable_variation {

/// Production simulated, with its files.
struct SimulationCalculation {
  Simulation simulation;
  SimulationPaths paths;
  AnswerStatus status;       ///< cancelled: ended before; io_error: a file could not be written
  double report_time = 0.0;  ///< for statistics and report on file [s]
};

/// @param snapshot as snapshotFor() gives it
/// @param evaluator of its scene, whatever its nominal shape
/// @param exchange of blocks with files and other processes, or nullptr
/// Cancelled, it has the samples done by then. Throws as simulateVariation(), SimulationFiles.
SimulationCalculation calculateSimulation(const SimulationTask& task, const DesignSnapshot& snapshot,
                                          const MeasureEvaluator& evaluator, const OutputDirectory& output,
                                          RunControl& control, BlockExchange* exchange = nullptr);

}  // namespace cable_variation
