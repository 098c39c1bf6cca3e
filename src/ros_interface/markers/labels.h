#pragma once

#include <vector>

#include <cable_variation/Labels.h>

#include <cable_variation/equilibrium/equilibrium.h>
#include <ros_interface/markers/interference_markers.h>

namespace cable_variation_ros {

/// The names of clips, each at its clip; those of free clips only with an equilibrium.
std::vector<cable_variation::Label> clipLabels(const cable_variation::Equilibrium& equilibrium,
                                               const cable_variation::Harness& harness);

/// What distances are, each at its point of the cable; faults where parts interfere.
std::vector<cable_variation::Label> distanceLabels(const std::vector<DistanceMark>& marks);

}  // namespace cable_variation_ros
