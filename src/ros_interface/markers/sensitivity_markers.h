#pragma once

#include <visualization_msgs/MarkerArray.h>

#include <cable_variation/CableTubes.h>
#include <cable_variation/Legend.h>

#include <cable_variation/equilibrium/equilibrium.h>
#include <cable_variation/scene/scene.h>

namespace cable_variation_ros {

struct SensitivityView {
  visualization_msgs::MarkerArray markers;
  cable_variation::CableTubes tubes;  ///< the cables with those values
  cable_variation::Legend legend;     ///< its topic is left to whoever publishes it
};

/// How the shape changes with a design variable, namespace sensitivity/CABLE: each
/// cable in the colour of |∂φ/∂x| and, along it, arrows of the shift at the
/// variable's upper limit (lower, if that is 0), all enlarged by a factor that the
/// legend states. Points keep their share of the piece of cable between two clips,
/// joints or ends.
/// @param equilibrium converged, of `harness`
/// @param rate of the equilibrium, per unit of `variable`
SensitivityView sensitivityView(const cable_variation::DesignVariable& variable,
                                const cable_variation::Harness& harness,
                                const cable_variation::Equilibrium& equilibrium,
                                const cable_variation::EquilibriumRate& rate);

}  // namespace cable_variation_ros
