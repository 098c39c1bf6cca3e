#pragma once  // internal to envelope/

#include <functional>
#include <vector>

#include <cable_variation/envelope/search/phase_search.h>

namespace cable_variation {

/// Index of the phase that a time of the motions [s] belongs to.
std::size_t phaseAt(const std::vector<PhaseSearch>& phases, double time);

/// What is done with a solved place, by any thread: its number, its phase and its shape, without rates.
using ShapeTaker = std::function<void(std::size_t index, std::size_t phase, const FollowedShape& followed)>;

/// Solves many places around the references of their phases, in parallel: eight side by side where there are
/// many of one phase, and what that leaves is followed one by one. Each shape is the same, bit for bit,
/// whatever the number of threads.
void solvePlaces(const std::vector<PhaseSearch>& phases, const std::vector<SamplePlace>& places,
                 const ShapeTaker& take);

}  // namespace cable_variation
