#pragma once

#include <vector>

#include <visualization_msgs/MarkerArray.h>

#include <cable_variation/scene/scene.h>
#include <cable_variation/variation/measure_evaluation.h>

namespace cable_variation_ros {

/// The closest pairs of distances, namespace interference/MEASURE: a ball at each
/// of the two points, the line between them and, on a leader above the cable, the
/// distance and where along the cable it is. Red where parts overlap or come closer than the measure's lower
/// limit.
/// @param measures indices into Scene::measures, one for each of `values`; other kinds of measures show
/// nothing
visualization_msgs::MarkerArray interferenceMarkers(const cable_variation::Scene& scene,
                                                    const std::vector<std::size_t>& measures,
                                                    const std::vector<cable_variation::MeasureValue>& values);

}  // namespace cable_variation_ros
