#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include <cable_variation/harness/harness.h>
#include <cable_variation/util/quantity.h>

namespace cable_variation {

// Implausible values in a harness, wherever its figures come from. Texts name the values and what was
// probably meant; empty: nothing to say.

extern const Range kPlausibleStretchModulus;  ///< EA per area [Pa]; little for coiled cords
extern const Range kPlausibleBendingModulus;  ///< EI, GJ per second moment [Pa]; little where wires slide
extern const Range kPlausibleBulkDensity;     ///< mass per length and area [kg/m^3]; little for thin hoses

/// [m]; 0 without cables.
double longestCable(const Harness& harness);

/// Area and second moment of the round section of a radius [m^2, m^4].
double roundArea(double radius);
double roundSecondMoment(double radius);

/// EI and GJ against EA: stiffness in bending comes from what is within the radius [N m^2].
double mostBendingStiffness(double EA, double radius);

/// Thicker than long.
std::string thicknessSlip(const Cable& cable);

/// Bent at rest to less than its own radius.
std::string restShapeSlip(const Cable& cable);

/// Much longer than what it has to reach.
/// @param found the length as it was given
/// @param bare it was given without a unit
std::string lengthSlip(const Harness& harness, std::size_t cable, const std::string& found, bool bare);

struct ClipSlip {
  std::size_t clip;
  std::string text;
};
/// Clips that their cable cannot reach by far.
std::vector<ClipSlip> reachSlips(const Harness& harness, std::size_t cable);

/// Clips of a cable that hold it in a place, by arc length.
std::vector<std::size_t> placingClips(const Harness& harness, std::size_t cable);

/// How far away from its clips a cable may have a point that it is to pass [m].
double farthestReach(const Cable& cable);

}  // namespace cable_variation
