#include <ros_interface/markers/contact_markers.h>

#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>

#include <cable_variation/util/display_unit.h>
#include <ros_interface/conversion/message_conversion.h>
#include <ros_interface/markers/marker_colours.h>
#include <ros_interface/markers/marker_shapes.h>
#include <ros_interface/node/names.h>

namespace cable_variation_ros {

using cable_variation::ContactForce;
using cable_variation::ContactInterval;
using cable_variation::Equilibrium;
using Eigen::Vector3d;

namespace {

constexpr double kStep = 0.01;         // of cable that an arrow is the force of [m]
constexpr double kLongest = 0.08;      // of the cables' extent
constexpr double kShortest = 0.02;     // of the longest one; shorter ones are left out
constexpr double kThickness = 0.0008;  // radius [m]

struct Arrow {
  Vector3d start, force;
};

// The places of an interval, taken together within steps of its length.
std::vector<Arrow> arrowsOf(const ContactInterval& interval, const cable_variation::CableShape& shape) {
  std::vector<Arrow> arrows;
  const double steps = std::max(1.0, std::ceil((interval.end - interval.start) / kStep));
  const double step = (interval.end - interval.start) / steps;
  double current = -1.0, amount = 0.0;
  for (const ContactForce& place : interval.places) {
    const double number =
        step > 0.0 ? std::min(std::floor((place.arc_length - interval.start) / step), steps - 1.0) : 0.0;
    if (number != current) {
      arrows.push_back({Vector3d::Zero(), Vector3d::Zero()});
      amount = 0.0;
    }
    current = number;
    // the far side of the tube from the part
    const Vector3d centre = shape.position(place.arc_length);
    const Vector3d far = centre + shape.radius * place.direction;
    amount += place.force;
    arrows.back().start += place.force / amount * (far - arrows.back().start);
    arrows.back().force += place.force * place.direction;
  }
  return arrows;
}

double extentOf(const Equilibrium& equilibrium) {
  Eigen::AlignedBox3d box;
  for (const cable_variation::CableShape& shape : equilibrium.shapes) {
    for (const cable_variation::ShapePoint& point : shape.points) box.extend(point.pose.position);
  }
  return box.isEmpty() ? 0.0 : box.sizes().maxCoeff();
}

}  // namespace

visualization_msgs::MarkerArray contactMarkers(const Equilibrium& equilibrium,
                                               const cable_variation::Harness& harness) {
  visualization_msgs::MarkerArray array;
  if (!equilibrium.converged()) return array;
  std::vector<std::vector<Arrow>> arrows(harness.cables.size());
  double largest = 0.0;  // [N]
  for (const ContactInterval& interval : equilibrium.contacts) {
    for (const Arrow& arrow : arrowsOf(interval, equilibrium.shapes[interval.cable])) {
      arrows[interval.cable].push_back(arrow);
      largest = std::max(largest, arrow.force.norm());
    }
  }
  if (!(largest > 0.0)) return array;
  const double scale = kLongest * extentOf(equilibrium) / largest;
  for (std::size_t i = 0; i < arrows.size(); ++i) {
    MarkerGroup group(kContactMarkers + harness.cables[i].name, kWorldFrame, cableColour(i));
    for (const Arrow& arrow : arrows[i]) {
      if (arrow.force.norm() < kShortest * largest) continue;
      group.addArrow(arrow.start, arrow.start + scale * arrow.force, kThickness);
    }
    array.markers.insert(array.markers.end(), group.markers().begin(), group.markers().end());
  }
  return array;
}

std::vector<cable_variation::Label> contactLabels(const Equilibrium& equilibrium) {
  std::vector<cable_variation::Label> labels;
  if (!equilibrium.converged()) return labels;
  for (const ContactInterval& interval : equilibrium.contacts) {
    const auto hardest =
        std::max_element(interval.places.begin(), interval.places.end(),
                         [](const ContactForce& a, const ContactForce& b) { return a.force < b.force; });
    if (hardest == interval.places.end()) continue;
    cable_variation::Label label;
    label.kind = cable_variation::Label::FIGURE;
    label.text = cable_variation::displayValue(interval.total, "N");
    label.at = toPoint(hardest->on_part);
    labels.push_back(label);
  }
  return labels;
}

}  // namespace cable_variation_ros
