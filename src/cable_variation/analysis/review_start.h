#pragma once

#include <string>
#include <vector>

#include <cable_variation/report/review.h>
#include <cable_variation/analysis/design_snapshot.h>

namespace cable_variation {

/// A review of the scene with the date of now and the scene's warnings; the analyses are
/// still to be put in. What is referred to must outlive it.
Review startReview(const std::string& title, const DesignOrigin& origin, const Scene& scene,
                   const DesignValues& values, const SolvedScene& solved);

/// "engine_run and brake" of some motions.
std::string motionText(const Scene& scene, const std::vector<std::size_t>& motions);

}  // namespace cable_variation
