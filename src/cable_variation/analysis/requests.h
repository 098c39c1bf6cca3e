#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace cable_variation {

// What may be asked of a design, as it comes from outside: unchecked, names as texts, and 0 or nothing where
// the default is meant. The fields are those of the services, whose definitions (srv/) say what they mean.

/// As SolveEquilibrium.
struct EquilibriumRequest {
  std::vector<std::string> variables;
  std::vector<double> values;
  std::string motion;
  double time = 0.0;  ///< [s]
  bool follow = false;
  std::string report;
};

/// As AnalyzeStability, without what RViz is to show.
struct StabilityRequest {
  std::vector<std::string> variables;
  std::vector<std::string> measures;
  std::vector<std::string> nominal_variables;
  std::vector<double> nominal_values;
  bool skip_low_high = false;
  std::string report;
};

/// As GenerateEnvelope, without what RViz is to show.
struct EnvelopeRequest {
  std::vector<std::string> cables;
  std::vector<std::string> variables;
  bool motion_only = false;
  std::vector<std::string> motions;
  double from_time = 0.0;  ///< [s]
  double to_time = 0.0;    ///< [s]
  std::vector<std::string> nominal_variables;
  std::vector<double> nominal_values;
  double probability = 0.0;
  double margin = 0.0;  ///< [m]
  bool non_conservative = false;
  std::uint32_t verification_shapes = 0;
  std::uint32_t tightness_shapes = 0;
  double tightness_voxel = 0.0;  ///< [m]
  std::uint64_t seed = 0;
  double mesh_excess = 0.0;      ///< [m]
  double skip_near_clips = 0.0;  ///< [m]
  std::string name;
};

/// As SimulateVariation, without what RViz is to show but the shapes that are kept for it.
struct SimulationRequest {
  std::uint64_t samples = 0;
  std::uint64_t first_sample = 0;  ///< not of the service: a part of a simulation, from this index on
  double sigma_error = 0.0;
  double confidence = 0.0;
  std::uint64_t seed = 0;
  std::string sampler;
  std::vector<std::string> variables;
  std::vector<std::string> measures;
  std::vector<std::string> nominal_variables;
  std::vector<double> nominal_values;
  std::vector<std::string> motions;
  double from_time = 0.0;  ///< [s]
  double to_time = 0.0;    ///< [s]
  std::uint32_t sections = 0;
  std::uint32_t sample_shapes = 0;
  std::string name;
};

}  // namespace cable_variation
