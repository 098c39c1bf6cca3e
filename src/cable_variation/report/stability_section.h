#pragma once

#include <string>

#include <cable_variation/report/section.h>
#include <cable_variation/scene/scene.h>
#include <cable_variation/sensitivity/stability_analysis.h>

namespace cable_variation {

/// The chapter of a report on a stability analysis: measures and their limits, warnings, sensitivities,
/// contributions, low and high, the design's values, eigenvalues. Lengths in mm, angles in degrees.
/// @param values of the design analysed, as StabilityOptions::values
ReportSection stabilitySection(const Scene& scene, const StabilityAnalysis& analysis,
                               const DesignValues& values);

/// What the coupling of a design is, a sentence.
std::string couplingText(Coupling coupling);

/// Why a low or a high is not defined, and whether a snap lies before it; empty: nothing to say.
std::string lowHighNote(const Scene& scene, const StabilityAnalysis& analysis, std::size_t measure,
                        std::size_t variable);

/// One line per measure and variable, with a heading: nominal value, derivative, contribution, low, high and
/// what belongs to the measure and to the variable alone. SI units, 17 significant digits, names quoted (RFC
/// 4180). What is not defined is nan, and the notes at the end of the line say why.
std::string stabilityCsv(const Scene& scene, const StabilityAnalysis& analysis, const DesignValues& values);

}  // namespace cable_variation
