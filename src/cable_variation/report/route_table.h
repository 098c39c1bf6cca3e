#pragma once

#include <string>
#include <vector>

#include <cable_variation/measures/measure_evaluation.h>
#include <cable_variation/report/section.h>

namespace cable_variation {

// How far cables are from their planned routes. `measures` are indices into Scene::measures, of which those
// of the type route_deviation count; `values` are one each.

/// A row for each, the largest deviation first [mm]; no rows: the scene has no such measure.
ReportTable routeTable(const Scene& scene, const std::vector<std::size_t>& measures,
                       const std::vector<MeasureValue>& values);

/// The same as CSV (RFC 4180, SI units in the titles), in the scene's order: segment, measure, cable, its
/// stretch, deviation and limits, and the two places that are furthest apart: on the cable, and on the route.
/// Where there is no value it is nan.
std::string routeCsv(const Scene& scene, const std::vector<std::size_t>& measures,
                     const std::vector<MeasureValue>& values);

/// Indices of the scene's route_deviation measures.
std::vector<std::size_t> routeMeasures(const Scene& scene);

/// Those of `measures` that are not shown by routeTable() alone: all but deviations without limits.
std::vector<std::size_t> withoutPlainRoutes(const Scene& scene, const std::vector<std::size_t>& measures);

}  // namespace cable_variation
