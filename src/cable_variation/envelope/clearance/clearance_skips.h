#pragma once  // internal to envelope/

#include <vector>

#include <cable_variation/envelope/clearance/envelope_clearance.h>
#include <cable_variation/geometry/tube_distance/distance.h>

namespace cable_variation {

// What does not count in the clearances of an envelope: the options, else the scene's distance measures, else
// a default.

/// How close to its clips on a component a cable does not count against it [m].
double skippedNearClips(const Scene& scene, const ClearanceOptions& options, std::size_t cable,
                        std::size_t component);

/// The way through the joint of two cables from which on their sections count as pairs [m].
/// @param radii of the two together [m]
double skippedNearJoints(const Scene& scene, const ClearanceOptions& options, std::size_t cable,
                         std::size_t other, double radii);

/// Clips that are attached to a cable and ride on a component: near them it does not count against it.
std::vector<std::size_t> clipsBetween(const Scene& scene, const Harness& harness, std::size_t cable,
                                      const std::string& component);

/// The stretches within `near` [m] of where clips on a component hold the cable.
std::vector<SkippedStretch> stretchesNearClips(const Scene& scene, const Harness& harness,
                                               const Equilibrium& equilibrium, std::size_t cable,
                                               const std::string& component, double near);

}  // namespace cable_variation
