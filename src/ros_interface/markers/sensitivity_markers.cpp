#include <ros_interface/markers/sensitivity_markers.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

#include <ros_interface/markers/cable_markers.h>
#include <ros_interface/markers/cable_tubes.h>
#include <ros_interface/markers/colour_map.h>
#include <ros_interface/node/names.h>

namespace cable_variation_ros {

using cable_variation::CableShape;
using cable_variation::DesignVariable;
using cable_variation::Equilibrium;
using cable_variation::EquilibriumRate;
using cable_variation::Harness;
using cable_variation::ShapePoint;
using cable_variation::ShapePointRate;

namespace {

constexpr double kThickness = 1.06;         // times the cable's, which it covers
constexpr double kSegment = 0.004;          // of one colour [m]
constexpr double kArrowStep = 0.012;        // along the cable [m]
constexpr double kMostArrows = 200.0;       // per cable
constexpr double kLongestArrow = 0.16;      // of the harness's largest extent
constexpr double kShortestArrow = 0.02;     // of the longest one; shorter ones are dots
constexpr double kArrowThickness = 0.0012;  // radius [m]
const Eigen::Vector4d kArrowColor(0.96, 0.97, 0.98, 1.0);

/// ∂φ/∂x at an arc length, linear between the points of the shape.
Eigen::Vector3d shiftAt(const CableShape& shape, const std::vector<ShapePointRate>& rates, double s) {
  const auto above =
      std::upper_bound(shape.points.begin(), shape.points.end(), s,
                       [](double at, const ShapePoint& point) { return at < point.arc_length; });
  if (above == shape.points.begin()) return rates.front().position;
  if (above == shape.points.end()) return rates.back().position;
  const auto i = static_cast<std::size_t>(above - shape.points.begin());
  const double start = shape.points[i - 1].arc_length;
  const double share = (s - start) / (shape.points[i].arc_length - start);
  return (1.0 - share) * rates[i - 1].position + share * rates[i].position;
}

double largestShift(const EquilibriumRate& rate) {
  double largest = 0.0;
  for (const std::vector<ShapePointRate>& cable : rate.shapes) {
    for (const ShapePointRate& point : cable) largest = std::max(largest, point.position.norm());
  }
  return largest;
}

double largestExtent(const Equilibrium& equilibrium) {
  Eigen::AlignedBox3d box;
  for (const CableShape& shape : equilibrium.shapes) {
    for (const ShapePoint& point : shape.points) box.extend(point.pose.position);
  }
  return box.sizes().maxCoeff();
}

/// The largest of ..., 0.5, 1, 2, 5, 10, ... that is at most `limit` > 0.
double roundedDown(double limit) {
  const double decade = std::pow(10.0, std::floor(std::log10(limit)));
  for (const double step : {5.0, 2.0}) {
    if (step * decade <= limit) return step * decade;
  }
  return decade;
}

/// A unit that people use: the SI unit times `factor`.
struct CommonUnit {
  std::string name;
  double factor;
};

CommonUnit commonUnit(const std::string& si) {
  if (si == "m") return {"mm", 1e3};
  if (si == "rad") return {"deg", 180.0 / M_PI};
  return {si, 1.0};
}

double shownDeviation(const DesignVariable& variable) {
  return variable.upper != 0.0 ? variable.upper : variable.lower;
}

std::string arrowNote(const DesignVariable& variable, double enlargement) {
  const CommonUnit unit = commonUnit(variable.unit);
  char text[128];
  std::snprintf(text, sizeof text, "arrows: shift at %+.3g %s", unit.factor * shownDeviation(variable),
                unit.name.c_str());
  if (enlargement == 1.0) return text;
  char enlarged[48];
  std::snprintf(enlarged, sizeof enlarged, ", enlarged %g times", enlargement);
  return std::string(text) + enlarged;
}

cable_variation::Legend legendOf(const DesignVariable& variable, double largest, double enlargement) {
  const CommonUnit unit = commonUnit(variable.unit);
  cable_variation::Legend legend;
  legend.title = "Sensitivity to " + variable.name;
  legend.quantity = "shift of the cable";
  legend.unit = unit.name == "1"
                    ? "mm"
                    : "mm/" + (unit.name.find(' ') == std::string::npos ? unit.name : "(" + unit.name + ")");
  legend.maximum = 1e3 * largest / unit.factor;
  legend.note = enlargement > 0.0 ? arrowNote(variable, enlargement) : "no cable moves";
  return legend;
}

void addArrows(MarkerGroup& group, const CableShape& shape, const std::vector<ShapePointRate>& rates,
               double length, double scale, double shortest) {
  const double pieces = std::clamp(std::ceil(length / kArrowStep), 1.0, kMostArrows);
  for (double i = 0.0; i <= pieces; ++i) {
    const double s = i / pieces * length;
    const Eigen::Vector3d arrow = scale * shiftAt(shape, rates, s);
    if (arrow.norm() < shortest) continue;
    const Eigen::Vector3d start = shape.position(s);
    group.addArrow(start, start + arrow, kArrowThickness);
  }
}

}  // namespace

SensitivityView sensitivityView(const DesignVariable& variable, const Harness& harness,
                                const Equilibrium& equilibrium, const EquilibriumRate& rate) {
  const double largest = largestShift(rate);
  const double deviation = shownDeviation(variable);
  const double longest = kLongestArrow * largestExtent(equilibrium);
  const double enlargement = largest > 0.0 ? roundedDown(longest / (largest * std::abs(deviation))) : 0.0;
  const ColourScale colours(0.0, largest);

  SensitivityView view;
  for (std::size_t i = 0; i < equilibrium.shapes.size(); ++i) {
    const CableShape& shape = equilibrium.shapes[i];
    const std::vector<ShapePointRate>& rates = rate.shapes[i];
    MarkerGroup group(kSensitivityMarkers + harness.cables[i].name, kWorldFrame, kArrowColor);
    const auto color = [&](double s) {
      Eigen::Vector4d rgba = Eigen::Vector4d::Ones();
      rgba.head<3>() = colours(shiftAt(shape, rates, s).norm());
      return rgba;
    };
    addCable(group, shape, harness.cables[i], {kThickness, kSegment, color});
    group.setColor(kArrowColor);
    addArrows(group, shape, rates, harness.cables[i].length, enlargement * deviation,
              kShortestArrow * longest);
    view.markers.markers.insert(view.markers.markers.end(), group.markers().begin(), group.markers().end());
  }
  view.legend = legendOf(variable, largest, enlargement);
  const double shown = largest > 0.0 ? view.legend.maximum / largest : 0.0;  // in the legend's unit
  std::map<std::size_t, std::function<double(double)>> values;
  for (std::size_t i = 0; i < equilibrium.shapes.size(); ++i) {
    values[i] = [&shape = equilibrium.shapes[i], &rates = rate.shapes[i], shown](double s) {
      return shown * shiftAt(shape, rates, s).norm();
    };
  }
  view.tubes = valuedTubes(equilibrium, harness, variationQuantity(view.legend), values);
  return view;
}

}  // namespace cable_variation_ros
