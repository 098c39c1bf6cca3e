#include <ros_interface/markers/route_markers.h>

#include <cmath>
#include <optional>

#include <cable_variation/scene/scene.h>
#include <cable_variation/util/display_unit.h>
#include <ros_interface/conversion/message_conversion.h>
#include <ros_interface/markers/colour_map.h>
#include <ros_interface/markers/marker_shapes.h>
#include <ros_interface/node/names.h>

namespace cable_variation_ros {

using cable_variation::Label;
using cable_variation::Measure;
using cable_variation::MeasureValue;
using cable_variation::Scene;

namespace {

constexpr double kWidth = 0.001;         // of a route [m]
constexpr double kLeaderWidth = 0.0005;  // [m]

bool isKnown(const Scene& scene, const std::vector<MeasureValue>& values, std::size_t index) {
  return scene.measures[index].type == Measure::Type::route_deviation && index < values.size() &&
         std::isfinite(values[index].value);
}

/// The route that is furthest from its cable.
std::optional<std::size_t> furthest(const Scene& scene, const std::vector<MeasureValue>& values) {
  std::optional<std::size_t> found;
  for (std::size_t i = 0; i < scene.measures.size(); ++i) {
    if (isKnown(scene, values, i) && (!found || values[i].value > values[*found].value)) found = i;
  }
  return found;
}

}  // namespace

visualization_msgs::MarkerArray routeMarkers(const Scene& scene, const std::vector<MeasureValue>& values) {
  visualization_msgs::MarkerArray array;
  const std::optional<std::size_t> worst = furthest(scene, values);
  const ColourScale scale(0.0, worst ? values[*worst].value : 0.0);
  for (std::size_t i = 0; i < scene.measures.size(); ++i) {
    const Measure& measure = scene.measures[i];
    if (measure.type != Measure::Type::route_deviation) continue;
    const bool known = isKnown(scene, values, i);
    const Eigen::Vector3d colour = known ? scale(values[i].value) : viridis(std::nan(""));
    MarkerGroup group(kRouteMarkers + measure.name, kWorldFrame, {colour[0], colour[1], colour[2], 1.0});
    std::vector<Eigen::Vector3d> ends;
    for (std::size_t k = 0; k + 1 < measure.route.size(); ++k)
      ends.insert(ends.end(), {measure.route[k], measure.route[k + 1]});
    group.addLines(ends, kWidth);
    if (known && values[i].has_other) group.addLines({values[i].point, values[i].other}, kLeaderWidth);
    array.markers.insert(array.markers.end(), group.markers().begin(), group.markers().end());
  }
  return array;
}

std::vector<Label> routeLabels(const Scene& scene, const std::vector<MeasureValue>& values) {
  std::vector<Label> labels;
  const std::optional<std::size_t> worst = furthest(scene, values);
  for (std::size_t i = 0; i < scene.measures.size(); ++i) {
    if (!isKnown(scene, values, i)) continue;
    const bool beyond = beyondLimits(scene.measures[i], values[i].value);
    if (!beyond && i != *worst) continue;
    Label label;
    label.kind = beyond ? Label::FAULT : Label::FIGURE;
    label.text = scene.measures[i].name + " " + cable_variation::displayValue(values[i].value, "m");
    label.at = toPoint(values[i].point);
    labels.push_back(label);
  }
  return labels;
}

}  // namespace cable_variation_ros
