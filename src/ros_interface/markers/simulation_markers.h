#pragma once

#include <visualization_msgs/MarkerArray.h>

#include <cable_variation/CableTubes.h>
#include <cable_variation/Legend.h>

#include <cable_variation/simulation/simulation.h>
#include <ros_interface/markers/variation_figure.h>

namespace cable_variation_ros {

struct SimulationView {
  visualization_msgs::MarkerArray markers;
  cable_variation::CableTubes tubes;  ///< the cables with those values
  cable_variation::Legend legend;     ///< its topic is left to whoever publishes it
};

/// How production varies the cables. Namespace variation/CABLE: each cable of the design in the colour of its
/// variation at every arc length; variation_shapes/CABLE: the shapes kept, as thin translucent lines, of
/// which those that snapped to another equilibrium have a colour of their own.
/// @param over_motion the figures are of Simulation::shown_time, which the legend tells
SimulationView simulationView(const cable_variation::Scene& scene,
                              const cable_variation::Simulation& simulation, VariationFigure figure,
                              bool over_motion);

}  // namespace cable_variation_ros
