#include <ros_interface/markers/interference_markers.h>

#include <cmath>
#include <cstdio>

#include <cable_variation/scene/measure_traits.h>
#include <ros_interface/markers/label_placing.h>
#include <ros_interface/markers/marker_colours.h>
#include <ros_interface/markers/marker_shapes.h>
#include <ros_interface/node/names.h>

namespace cable_variation_ros {

using cable_variation::Measure;
using cable_variation::MeasureValue;

namespace {

const Eigen::Vector4d kNeutral(0.90, 0.94, 0.98, 1.0);
constexpr double kBall = 0.0016;       // radius [m]
constexpr double kLine = 0.0006;       // radius [m]
constexpr double kLeader = 0.0003;     // radius [m]
constexpr double kTextHeight = 0.012;  // [m]; RViz loses points of smaller figures
constexpr double kTextAbove = 0.035;   // the cable, out of what is around it [m]

bool interferes(const Measure& measure, double distance) {
  return distance < 0.0 || (measure.lower && distance < *measure.lower);
}

MarkerGroup pairOf(const DistanceMark& mark) {
  MarkerGroup group(mark.marker_namespace, kWorldFrame, mark.interferes ? kInterferenceRed : kNeutral);
  group.addSphere(mark.point, kBall);
  group.addSphere(mark.other, kBall);
  group.addCylinder(mark.point, mark.other, kLine);
  return group;
}

}  // namespace

std::string distanceText(double distance, double arc_length) {
  const double millimetres = std::abs(1e3 * distance);
  const int decimals = millimetres < 100.0 ? 1 : 0;
  char text[80];
  // A minus sign is easily lost among the parts.
  std::snprintf(text, sizeof text, "%s%.*f mm at s = %.0f mm", distance < 0.0 ? "overlap " : "", decimals,
                millimetres, 1e3 * arc_length);
  return text;
}

std::vector<DistanceMark> distanceMarks(const cable_variation::Scene& scene,
                                        const std::vector<std::size_t>& measures,
                                        const std::vector<MeasureValue>& values) {
  std::vector<DistanceMark> marks;
  for (std::size_t i = 0; i < measures.size(); ++i) {
    const Measure& measure = scene.measures[measures[i]];
    const MeasureValue& value = values[i];
    if (!traitsOf(measure.type).clearance || !value.has_place || !value.has_other) continue;
    DistanceMark mark;
    mark.marker_namespace = kInterferenceMarkers + measure.name;
    mark.point = value.point;
    mark.other = value.other;
    mark.text = measure.name + " " + distanceText(value.value, value.arc_length);
    mark.interferes = interferes(measure, value.value);
    marks.push_back(mark);
  }
  return marks;
}

visualization_msgs::MarkerArray interferenceMarkers(const std::vector<DistanceMark>& marks,
                                                    const visualization_msgs::MarkerArray& others) {
  LabelPlacing labels;
  labels.keep(others);
  visualization_msgs::MarkerArray array;
  for (const DistanceMark& mark : marks) {
    MarkerGroup group = pairOf(mark);
    const Eigen::Vector3d half_line = 0.7 * kTextHeight * Eigen::Vector3d::UnitZ();
    const Eigen::Vector3d text =
        labels.place(mark.point + kTextAbove * Eigen::Vector3d::UnitZ() + half_line, mark.text, kTextHeight);
    group.addCylinder(mark.point, text - half_line, kLeader);
    group.addText(text, mark.text, kTextHeight);
    array.markers.insert(array.markers.end(), group.markers().begin(), group.markers().end());
  }
  return array;
}

visualization_msgs::MarkerArray pairMarkers(const std::vector<DistanceMark>& marks) {
  visualization_msgs::MarkerArray array;
  for (const DistanceMark& mark : marks) {
    const MarkerGroup group = pairOf(mark);
    array.markers.insert(array.markers.end(), group.markers().begin(), group.markers().end());
  }
  return array;
}

}  // namespace cable_variation_ros
