#pragma once

#include <string>

#include <cable_variation/CableTubes.h>
#include <cable_variation/EnvelopeMesh.h>
#include <cable_variation/Labels.h>

namespace cable_variation_rviz {

// What a message has that cannot be drawn, for a person to read; empty: nothing. Coordinates that are not
// finite, or beyond 1e9 m, would stop RViz.

/// Values along a cable need not be numbers.
std::string faultOf(const cable_variation::CableTubes& tubes);
std::string faultOf(const cable_variation::EnvelopeMesh& envelope);
std::string faultOf(const cable_variation::Labels& labels);

}  // namespace cable_variation_rviz
