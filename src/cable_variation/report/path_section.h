#pragma once

#include <string>
#include <vector>

#include <cable_variation/path/path_check.h>
#include <cable_variation/report/section.h>

namespace cable_variation {

/// A path that was checked, for a report; what is referred to must outlive it.
struct PathFindings {
  const PathCheck& check;
  bool over_time = false;  ///< charts have the time along them, else the way that was come
};

/// The chapter of a report on a path: what happened on it and where, the worst of each measure, and measures,
/// clip forces, bend radii and the smallest eigenvalue along it.
ReportSection pathSection(const Scene& scene, const PathFindings& found);

/// What makes a path a bad one beside its measures, a few words each: snaps, stretches without an
/// equilibrium, clips that could not close.
std::vector<std::string> pathFaults(const PathCheck& check);

/// One row per sample: time, way, eigenvalue, each measure, each clip's reaction, each cable's bend radius,
/// all in SI units; where there is no equilibrium they are nan.
std::string pathCsv(const Scene& scene, const PathCheck& check);

}  // namespace cable_variation
