#pragma once  // internal to envelope/

#include <vector>

#include <cable_variation/envelope/search/phase_search.h>
#include <cable_variation/tracking/motion_phases.h>
#include <cable_variation/util/progress.h>

namespace cable_variation {

/// A search for each phase, from the design's shape at its reference, which is followed from phase to phase.
/// @param solver has the design's shape at the first phase @param tolerance of the searches [m]
/// @param report told of the first tenth of all
/// @param envelope warned if the design itself does not follow the motion smoothly
/// Throws as requireConverged(): no equilibrium of the design in a phase.
std::vector<PhaseSearch> searchesAlongDesign(const StretchReader& reader, const EquilibriumSolver& solver,
                                             const std::vector<MotionPhase>& phases, double tolerance,
                                             ProgressReporter& report, Envelope& envelope);

}  // namespace cable_variation
