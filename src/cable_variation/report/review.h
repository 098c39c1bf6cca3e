#pragma once

#include <optional>
#include <string>
#include <vector>

#include <cable_variation/measures/measure_evaluation.h>
#include <cable_variation/report/envelope_section.h>
#include <cable_variation/report/page.h>
#include <cable_variation/report/path_section.h>
#include <cable_variation/simulation/simulation.h>

namespace cable_variation {

/// A design that was analysed, to be reported on; what is referred to must outlive it. The analyses' figures
/// are shown as they are.
struct Review {
  std::string title;              ///< "Stability analysis"
  std::string date;               ///< for a person, with its time zone
  std::string author;             ///< empty: not told
  std::vector<ReportFact> about;  ///< what was asked for, beside what the page tells by itself
  std::vector<std::string> warnings;
  std::string source_hash;           ///< SHA-256 of the scene's file when it was read; empty: not known
  std::vector<std::string> changes;  ///< of the scene since it was read, designChanges()

  const Scene& scene;
  const DesignValues& values;          ///< of the design, as StabilityOptions::values
  const SolvedScene& solved;           ///< the design at rest, converged
  std::vector<std::size_t> measures;   ///< indices
  std::vector<MeasureValue> measured;  ///< of the design, one each
  std::vector<std::size_t> variables;  ///< that vary, indices

  const StabilityAnalysis* stability = nullptr;
  const Simulation* simulation = nullptr;
  std::optional<EnvelopeFindings> envelope;
  std::optional<PathFindings> path = {};  ///< measures are then judged by their worst along it
};

/// All of it as one page: the verdict on each measure, a picture of the scene, the tolerances; then the
/// design at rest with what acts along its cables, and a chapter for each analysis that was done.
std::string reviewPage(const Review& review);

}  // namespace cable_variation
