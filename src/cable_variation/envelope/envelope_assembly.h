#pragma once  // internal to envelope/

#include <vector>

#include <cable_variation/envelope/envelope.h>
#include <cable_variation/envelope/search/phase_search.h>

namespace cable_variation {

constexpr std::size_t kSolvesOverMotion = 20000;  ///< that the phases of a motion share

/// Per phase and branch of its search: the branch's number in the envelope. 0: the design's own in all
/// phases.
std::vector<std::vector<std::size_t>> branchNumbers(const std::vector<PhaseSearch>& searches);

/// Puts what the searches of all phases have found into the envelope: phases, samples, snaps, the pieces of
/// every frame, inflated as the envelope says, counts and warnings.
/// @param largest_solves that each search was allowed
void assembleEnvelope(const std::vector<PhaseSearch>& searches, std::size_t largest_solves,
                      Envelope& envelope);

/// Warns of phases that are longer than wanted for what memory is enough for, and of those whose searches
/// leave more than the tolerance that they began with [m].
/// @param wanted,most phases @param memory_limit [B]
void warnOfCoarsening(const std::vector<PhaseSearch>& searches, std::size_t wanted, std::size_t most,
                      double memory_limit, double tolerance, Envelope& envelope);

}  // namespace cable_variation
