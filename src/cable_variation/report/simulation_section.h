#pragma once

#include <string>

#include <cable_variation/report/section.h>
#include <cable_variation/scene/scene.h>
#include <cable_variation/sensitivity/stability_analysis.h>
#include <cable_variation/simulation/simulation_statistics.h>

namespace cable_variation {

/// The chapter of a report on a simulation of production: statistics with their intervals, capability against
/// the limits, percentiles, histograms, contributions, samples that were not solved. Lengths in mm, angles in
/// degrees.
/// @param values of the design simulated, as StabilityOptions::values
/// @param linear analysis of the same design, whose contributions are shown beside the simulated ones;
/// nullptr: none
ReportSection simulationSection(const Scene& scene, const SimulationStatistics& statistics,
                                const DesignValues& values, const StabilityAnalysis* linear = nullptr);

/// One line per measure, with a heading: all its statistics. SI units, 17 significant digits, names quoted
/// (RFC 4180); empty: it has none.
std::string statisticsCsv(const Scene& scene, const SimulationStatistics& statistics);

/// One line per measure and variable: regression and first-order Sobol' index.
std::string contributionCsv(const Scene& scene, const SimulationStatistics& statistics);

}  // namespace cable_variation
