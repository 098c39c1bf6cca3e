#pragma once

#include <string>

#include <cable_variation/AnalyzeStability.h>
#include <cable_variation/GenerateEnvelope.h>
#include <cable_variation/SimulateVariation.h>
#include <cable_variation/SolveEquilibrium.h>

#include <cable_variation/analysis/requests.h>
#include <ros_interface/markers/variation_figure.h>

namespace cable_variation_ros {

// Requests as the core takes them: without what RViz is to show.
cable_variation::EquilibriumRequest fromMessage(const cable_variation::SolveEquilibriumRequest& message);
cable_variation::StabilityRequest fromMessage(const cable_variation::AnalyzeStabilityRequest& message);
cable_variation::EnvelopeRequest fromMessage(const cable_variation::GenerateEnvelopeRequest& message);
cable_variation::SimulationRequest fromMessage(const cable_variation::SimulateVariationRequest& message);

/// The field `show` of SimulateVariation. Throws std::invalid_argument.
VariationFigure figureOf(const std::string& show);

}  // namespace cable_variation_ros
