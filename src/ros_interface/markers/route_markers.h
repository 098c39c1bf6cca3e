#pragma once

#include <vector>

#include <visualization_msgs/MarkerArray.h>

#include <cable_variation/Label.h>

#include <cable_variation/measures/measure_evaluation.h>

namespace cable_variation_ros {

/// The routes of a scene's route_deviation measures as thin lines, namespace route/MEASURE: viridis from no
/// deviation to the largest of the harness. A second, thinner line is where each is furthest from its cable.
/// @param values of all measures of the scene, or none: without a value a route is grey
visualization_msgs::MarkerArray routeMarkers(const cable_variation::Scene& scene,
                                             const std::vector<cable_variation::MeasureValue>& values);

/// The largest deviation, and all beyond their limit as faults, where the cable is furthest from its route.
std::vector<cable_variation::Label> routeLabels(const cable_variation::Scene& scene,
                                                const std::vector<cable_variation::MeasureValue>& values);

}  // namespace cable_variation_ros
