#pragma once

#include <functional>
#include <map>

#include <cable_variation/CableTubes.h>
#include <cable_variation/Legend.h>

#include <cable_variation/equilibrium/equilibrium.h>

namespace cable_variation_ros {

/// Names of quantities along a cable, as CableQuantity has them.
constexpr char kCurvatureQuantity[] = "curvature";
constexpr char kStrainQuantity[] = "strain";
constexpr char kForceQuantity[] = "force";
constexpr char kVariationQuantity[] = "variation";

/// The cables of `harness` as `equilibrium` has them, with curvature of the centreline [1/m], strain (the
/// largest normal strain of a section, |stretch| + radius × bending [%]) and section force [N]. None unless
/// the equilibrium converged.
/// @param outdated there is no equilibrium now
cable_variation::CableTubes cableTubes(const cable_variation::Equilibrium& equilibrium,
                                       const cable_variation::Harness& harness, bool outdated);

/// Variation without its values: in unit and bounds of its legend.
cable_variation::CableQuantity variationQuantity(const cable_variation::Legend& legend);

/// The same cables with one quantity alone.
/// @param quantity its name, unit and bounds
/// @param values of cables by index, at an arc length [m]; other cables are left out
cable_variation::CableTubes valuedTubes(const cable_variation::Equilibrium& equilibrium,
                                        const cable_variation::Harness& harness,
                                        const cable_variation::CableQuantity& quantity,
                                        const std::map<std::size_t, std::function<double(double)>>& values);

/// Adds the quantities of `values` to the cables of `tubes`: to those that are where the values were
/// computed, within a fifth of a millimetre; the others as cables that are elsewhere. To outdated tubes
/// nothing is added.
void addValues(cable_variation::CableTubes& tubes, const cable_variation::CableTubes& values);

}  // namespace cable_variation_ros
