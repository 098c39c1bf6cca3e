#pragma once

#include <string>
#include <vector>

#include <cable_variation/analysis/design_snapshot.h>
#include <cable_variation/analysis/envelope_files.h>
#include <cable_variation/analysis/envelope_surfaces.h>
#include <cable_variation/analysis/envelope_task.h>
#include <cable_variation/analysis/run_control.h>
#include <cable_variation/envelope/clearance/envelope_clearance.h>

namespace cable_variation {

/// An envelope with its clearances and its surface.
struct EnvelopeCalculation {
  EquilibriumSolver solver;  ///< the design's shape to follow
  Envelope envelope;
  std::vector<EnvelopeClearance> clearances;
  EnvelopeSurfaces surfaces;
  double volume = 0.0;                ///< within the surface [m³]
  double clearance_time = 0.0;        ///< [s]
  double surface_time = 0.0;          ///< [s]
  std::vector<std::string> warnings;  ///< of the envelope, of open parts and of a coarse surface
};

/// @param snapshot as snapshotFor() gives it
/// @param by_cable whether the surface of each cable's envelope is wanted too
/// @param control told how far it is, and asked
/// Throws as generateEnvelope(), refuseFinerMeshThanMemory(); Cancelled.
EnvelopeCalculation calculateEnvelope(const EnvelopeTask& task, const DesignSnapshot& snapshot, bool by_cable,
                                      RunControl& control);

/// Completes the run and writes the files of the task's name, none if that is empty; one that cannot be
/// written is told in EnvelopeFiles::error and costs nothing else. Throws Cancelled.
/// @param warnings of the answer, for the report; what is to be said of the files is added
EnvelopeFiles writeEnvelope(const EnvelopeTask& task, const DesignSnapshot& snapshot,
                            const EnvelopeCalculation& found, const OutputDirectory& output,
                            std::vector<std::string>& warnings, RunControl& control);

}  // namespace cable_variation
