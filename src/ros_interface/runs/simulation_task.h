#pragma once

#include <string>

#include <cable_variation/SimulateVariation.h>

#include <cable_variation/scene/design.h>
#include <cable_variation/simulation/simulation.h>
#include <ros_interface/markers/variation_figure.h>

namespace cable_variation_ros {

/// What a request for a simulation asks for, checked and with its defaults.
struct SimulationTask {
  cable_variation::SimulationOptions options;
  bool other_design = false;  ///< nominal values were given
  VariationFigure show = VariationFigure::six_sigma;
  std::string name;  ///< of the files; empty: none
};

/// @param moved components that are not where the scene has them now
/// Throws cable_variation::NotFound for a name that is none, and std::invalid_argument that names the field,
/// its value and what is expected.
SimulationTask toSimulationTask(const cable_variation::SimulateVariationRequest& request,
                                const cable_variation::Design& design,
                                const cable_variation::ComponentPoses& moved, std::size_t threads,
                                double memory_limit);

}  // namespace cable_variation_ros
