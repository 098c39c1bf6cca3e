#pragma once

#include <vector>

#include <visualization_msgs/MarkerArray.h>

#include <cable_variation/Label.h>

#include <cable_variation/equilibrium/equilibrium.h>

namespace cable_variation_ros {

/// What parts press cables with, as arrows that start on the far side of the cable, namespace contact/CABLE.
/// Each is the force of some millimetres of cable, all in one scale, and of its cable's colour.
visualization_msgs::MarkerArray contactMarkers(const cable_variation::Equilibrium& equilibrium,
                                               const cable_variation::Harness& harness);

/// The force of each stretch that touches, where it presses hardest.
std::vector<cable_variation::Label> contactLabels(const cable_variation::Equilibrium& equilibrium);

}  // namespace cable_variation_ros
