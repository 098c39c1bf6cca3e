#pragma once

#include <optional>
#include <string>
#include <vector>

#include <cable_variation/envelope/clearance/envelope_clearance.h>
#include <cable_variation/scene/scene.h>
#include <cable_variation/sensitivity/stability_analysis.h>
#include <cable_variation/simulation/simulation.h>

namespace cable_variation {

/// Whether a figure keeps its limits.
enum class Verdict {
  pass,
  marginal,   ///< it does, with little room: Cpk of 1 to 1.33
  fail,       ///< it does not, at the design or as it is produced
  unknown,    ///< there is no figure to judge by
  no_limits,  ///< it has none
};

const char* toString(Verdict verdict);  ///< for a person: "pass"

constexpr double kCapable = 1.33;  ///< Cpk that is usually asked for; below 1 the spread does not fit

/// One measure of a scene, judged by what is known of it: by the Cpk of a simulation, else by that to first
/// order, else by the worst case, else by the design alone. Outside of its limits at the design it fails in
/// any case. What is not known is not a number.
struct MeasureVerdict {
  std::size_t measure = 0;  ///< index into Scene::measures
  Verdict verdict = Verdict::unknown;
  const char* basis = "";  ///< what it is judged by: "simulation", "first order", "worst case", "design"
  double value = 0.0;      ///< at the design [its unit]
  double sigma = 0.0;      ///< [its unit]
  double cpk = 0.0;        ///< of the basis
  double worst_low = 0.0, worst_high = 0.0;  ///< within the tolerances [its unit]
  double outside = 0.0;                      ///< share of the samples simulated
};

/// What is known of a scene's measures.
struct MeasureEvidence {
  std::vector<std::size_t> measures;          ///< indices
  std::vector<double> values;                 ///< of each at the design
  const StabilityAnalysis* linear = nullptr;  ///< of the same design
  const SimulationStatistics* simulation = nullptr;
  const std::vector<EnvelopeClearance>* clearances = nullptr;  ///< of an envelope of all tolerances
};

/// In the order of the evidence's measures.
std::vector<MeasureVerdict> verdictsOf(const Scene& scene, const MeasureEvidence& evidence);

/// Of a clearance and the lower limit of the scene's distance measures: fail when a harness solved breaks it,
/// marginal when only the bound does: it cannot be excluded then.
Verdict verdictOf(const Scene& scene, const EnvelopeClearance& clearance);

/// Of all measures and clearances with limits together, and how it reads: "2 of 7 checks fail: A, B".
struct OverallVerdict {
  Verdict verdict = Verdict::unknown;
  std::string text;
};
/// @param faults what fails beside, a few words each
OverallVerdict overallVerdict(const Scene& scene, const std::vector<MeasureVerdict>& measures,
                              const std::vector<EnvelopeClearance>& clearances,
                              const std::vector<std::string>& faults = {});

}  // namespace cable_variation
