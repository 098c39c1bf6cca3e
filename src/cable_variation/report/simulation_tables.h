#pragma once

#include <string>

#include <Eigen/Core>

#include <cable_variation/report/section.h>
#include <cable_variation/scene/scene.h>
#include <cable_variation/simulation/simulation_statistics.h>

namespace cable_variation {

// The tables of a simulation with samples.
ReportTable meanTable(const Scene& scene, const SimulationStatistics& statistics);
ReportTable capabilityTable(const Scene& scene, const SimulationStatistics& statistics);
ReportTable percentileTable(const Scene& scene, const SimulationStatistics& statistics);
ReportTable controlTable(const Scene& scene, const SimulationStatistics& statistics);

/// Shares in variance. @param share rows measures, columns variables
ReportTable shareTable(const Scene& scene, const SimulationStatistics& statistics, const std::string& caption,
                       const Eigen::MatrixXd& share);

/// Samples that were not simply solved. @param most of them
ReportTable listedTable(const Scene& scene, const SimulationStatistics& statistics,
                        const DesignValues& values, std::size_t most);

}  // namespace cable_variation
