#include <ros_interface/interference_markers.h>

#include <cmath>
#include <cstdio>

#include <ros_interface/marker_shapes.h>
#include <ros_interface/names.h>

namespace cable_variation_ros {

using cable_variation::Measure;
using cable_variation::MeasureValue;

namespace {

const Eigen::Vector4d kRed(0.93, 0.10, 0.12, 1.0);
const Eigen::Vector4d kNeutral(0.90, 0.94, 0.98, 1.0);
constexpr double kBall = 0.0016;       // radius [m]
constexpr double kLine = 0.0006;       // radius [m]
constexpr double kLeader = 0.0003;     // radius [m]
constexpr double kTextHeight = 0.009;  // [m]; as the clips' names
constexpr double kTextAbove = 0.035;   // the cable, out of what is around it [m]

bool interferes(const Measure& measure, double distance) {
  return distance < 0.0 || (measure.lower && distance < *measure.lower);
}

/// "D_CAR 4.0 mm at s = 231 mm"
std::string textOf(const Measure& measure, const MeasureValue& value) {
  const double millimetres = 1e3 * value.value;
  const int decimals = std::abs(millimetres) < 100.0 ? 1 : 0;
  char text[64];
  std::snprintf(text, sizeof text, " %.*f mm at s = %.0f mm", decimals, millimetres, 1e3 * value.arc_length);
  return measure.name + text;
}

}  // namespace

visualization_msgs::MarkerArray interferenceMarkers(const cable_variation::Scene& scene,
                                                    const std::vector<std::size_t>& measures,
                                                    const std::vector<MeasureValue>& values) {
  visualization_msgs::MarkerArray array;
  for (std::size_t i = 0; i < measures.size(); ++i) {
    const Measure& measure = scene.measures[measures[i]];
    const MeasureValue& value = values[i];
    if (measure.type != Measure::Type::distance || !value.has_place || !value.has_other) continue;
    MarkerGroup group(kInterferenceMarkers + measure.name, kWorldFrame,
                      interferes(measure, value.value) ? kRed : kNeutral);
    group.addSphere(value.point, kBall);
    group.addSphere(value.other, kBall);
    group.addCylinder(value.point, value.other, kLine);
    const Eigen::Vector3d above = value.point + kTextAbove * Eigen::Vector3d::UnitZ();
    group.addCylinder(value.point, above, kLeader);
    group.addText(above + 0.7 * kTextHeight * Eigen::Vector3d::UnitZ(), textOf(measure, value), kTextHeight);
    array.markers.insert(array.markers.end(), group.markers().begin(), group.markers().end());
  }
  return array;
}

}  // namespace cable_variation_ros
