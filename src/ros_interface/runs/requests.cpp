#include <ros_interface/runs/requests.h>

#include <stdexcept>

namespace cable_variation_ros {

cable_variation::EquilibriumRequest fromMessage(const cable_variation::SolveEquilibriumRequest& message) {
  cable_variation::EquilibriumRequest request;
  request.variables = message.variables;
  request.values = message.values;
  request.motion = message.motion;
  request.time = message.time;
  request.follow = message.follow != 0;
  request.report = message.report;
  return request;
}

cable_variation::StabilityRequest fromMessage(const cable_variation::AnalyzeStabilityRequest& message) {
  cable_variation::StabilityRequest request;
  request.variables = message.variables;
  request.measures = message.measures;
  request.nominal_variables = message.nominal_variables;
  request.nominal_values = message.nominal_values;
  request.skip_low_high = message.skip_low_high != 0;
  request.report = message.report;
  return request;
}

cable_variation::EnvelopeRequest fromMessage(const cable_variation::GenerateEnvelopeRequest& message) {
  cable_variation::EnvelopeRequest request;
  request.cables = message.cables;
  request.variables = message.variables;
  request.motion_only = message.motion_only != 0;
  request.motions = message.motions;
  request.from_time = message.from_time;
  request.to_time = message.to_time;
  request.nominal_variables = message.nominal_variables;
  request.nominal_values = message.nominal_values;
  request.probability = message.probability;
  request.margin = message.margin;
  request.non_conservative = message.non_conservative != 0;
  request.verification_shapes = message.verification_shapes;
  request.tightness_shapes = message.tightness_shapes;
  request.tightness_voxel = message.tightness_voxel;
  request.seed = message.seed;
  request.mesh_excess = message.mesh_excess;
  request.skip_near_clips = message.skip_near_clips;
  request.name = message.name;
  return request;
}

cable_variation::SimulationRequest fromMessage(const cable_variation::SimulateVariationRequest& message) {
  cable_variation::SimulationRequest request;
  request.samples = message.samples;
  request.sigma_error = message.sigma_error;
  request.confidence = message.confidence;
  request.seed = message.seed;
  request.sampler = message.sampler;
  request.variables = message.variables;
  request.measures = message.measures;
  request.nominal_variables = message.nominal_variables;
  request.nominal_values = message.nominal_values;
  request.motions = message.motions;
  request.from_time = message.from_time;
  request.to_time = message.to_time;
  request.sections = message.sections;
  request.sample_shapes = message.sample_shapes;
  request.name = message.name;
  return request;
}

VariationFigure figureOf(const std::string& show) {
  if (show.empty() || show == "six_sigma") return VariationFigure::six_sigma;
  if (show == "range") return VariationFigure::range;
  throw std::invalid_argument("show: is '" + show + "', expected six_sigma or range");
}

}  // namespace cable_variation_ros
