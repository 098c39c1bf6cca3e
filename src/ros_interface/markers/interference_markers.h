#pragma once

#include <string>
#include <vector>

#include <visualization_msgs/MarkerArray.h>

#include <cable_variation/measures/measure_evaluation.h>
#include <cable_variation/scene/scene.h>

namespace cable_variation_ros {

/// Two closest points, with what is to be said of them.
struct DistanceMark {
  std::string marker_namespace;
  Eigen::Vector3d point = Eigen::Vector3d::Zero();  ///< on the cable or envelope [m, world]
  Eigen::Vector3d other = Eigen::Vector3d::Zero();
  std::string text;
  bool interferes = false;
};

/// "4.0 mm at s = 231 mm", "overlap 1.2 mm at s = 231 mm"
std::string distanceText(double distance, double arc_length);

/// The closest pairs of distances, namespace interference/MEASURE. They interfere where parts overlap or come
/// closer than the measure's lower limit.
/// @param measures indices into Scene::measures, one for each of `values`; other kinds of measures are left
/// out
std::vector<DistanceMark> distanceMarks(const cable_variation::Scene& scene,
                                        const std::vector<std::size_t>& measures,
                                        const std::vector<cable_variation::MeasureValue>& values);

/// A ball at each of the two points, the line between them and, on a leader above the cable, the text: red
/// where they interfere. Texts go up a line rather than hide each other or those of `others`.
visualization_msgs::MarkerArray interferenceMarkers(const std::vector<DistanceMark>& marks,
                                                    const visualization_msgs::MarkerArray& others = {});

/// The same without texts and their leaders.
visualization_msgs::MarkerArray pairMarkers(const std::vector<DistanceMark>& marks);

}  // namespace cable_variation_ros
