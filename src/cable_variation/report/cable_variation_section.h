#pragma once

#include <cable_variation/report/section.h>
#include <cable_variation/scene/scene.h>
#include <cable_variation/simulation/simulation.h>

namespace cable_variation {

/// Where each cable varies most, and in which direction.
ReportTable largestVariationTable(const Scene& scene, const Simulation& simulation);

/// The chapter of a report on how production varies the cables: six standard deviations and range along each
/// of them, where they are largest and in which direction; the times of a motion that were solved. Lengths in
/// mm.
ReportSection cableVariationSection(const Scene& scene, const Simulation& simulation);

}  // namespace cable_variation
