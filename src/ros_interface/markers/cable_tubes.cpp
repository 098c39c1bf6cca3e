#include <ros_interface/markers/cable_tubes.h>

#include <algorithm>
#include <cmath>

#include <ros_interface/conversion/message_conversion.h>
#include <ros_interface/node/names.h>

namespace cable_variation_ros {

using cable_variation::Cable;
using cable_variation::CableQuantity;
using cable_variation::CableShape;
using cable_variation::CableTube;
using cable_variation::CableTubes;
using cable_variation::Equilibrium;
using cable_variation::Harness;
using cable_variation::ShapePoint;

namespace {

constexpr double kFinestStep = 0.002;     // of stations [m]
constexpr double kMostStations = 1000.0;  // in all, not counting ends
constexpr double kSamePlace = 2e-4;       // not to be seen [m]

/// A value at an arc length of a shape, linear between its points.
double valueAt(const CableShape& shape, double s, double (*value)(const ShapePoint&)) {
  const std::vector<ShapePoint>& points = shape.points;
  const auto above =
      std::upper_bound(points.begin(), points.end(), s,
                       [](double at, const ShapePoint& point) { return at < point.arc_length; });
  if (above == points.begin()) return value(points.front());
  if (above == points.end()) return value(points.back());
  const ShapePoint &before = *(above - 1), &after = *above;
  const double share = (s - before.arc_length) / (after.arc_length - before.arc_length);
  return (1.0 - share) * value(before) + share * value(after);
}

double curvatureOf(const ShapePoint& point) {
  const double stretch = point.tangent.norm();
  return point.tangent.cross(point.second_derivative).norm() / (stretch * stretch * stretch);
}
double stretchOf(const ShapePoint& point) { return std::abs(point.strain.x()); }
double bendingOf(const ShapePoint& point) { return point.curvature.tail<2>().norm(); }
double forceOf(const ShapePoint& point) { return point.force.norm(); }

/// Longest step between stations.
double stepOf(const Harness& harness) {
  double length = 0.0;
  for (const Cable& cable : harness.cables) length += cable.length;
  return std::max(kFinestStep, length / kMostStations);
}

CableTube tubeOf(const CableShape& shape, const Cable& cable, double step, const Eigen::Vector3d& origin) {
  const auto wanted = static_cast<std::size_t>(std::ceil(cable.length / step)) + 1;
  CableTube tube;
  tube.cable = cable.name;
  const std::vector<cable_variation::Pose> poses = shape.sample(std::max<std::size_t>(wanted, 2));
  const double between = cable.length / static_cast<double>(poses.size() - 1);
  for (std::size_t i = 0; i < poses.size(); ++i) {
    const Eigen::Vector3f from_origin = (poses[i].position - origin).cast<float>();
    tube.position.insert(tube.position.end(), from_origin.data(), from_origin.data() + 3);
    tube.radius.push_back(static_cast<float>(sectionAt(cable, static_cast<double>(i) * between).radius));
  }
  return tube;
}

void addQuantity(CableTube& tube, CableQuantity quantity, double length,
                 const std::function<double(double)>& value) {
  const std::size_t count = tube.radius.size();
  for (std::size_t i = 0; i < count; ++i) {
    const double share = static_cast<double>(i) / static_cast<double>(count - 1);
    quantity.values.push_back(static_cast<float>(value(share * length)));
  }
  tube.quantities.push_back(std::move(quantity));
}

CableQuantity quantityCalled(const char* name, const char* unit) {
  CableQuantity quantity;
  quantity.name = name;
  quantity.unit = unit;
  return quantity;
}

CableTubes inWorld(const Eigen::Vector3d& origin) {
  CableTubes tubes;
  tubes.header.frame_id = kWorldFrame;
  tubes.origin = toPoint(origin);
  return tubes;
}

/// Whole metres: the same for all shapes of a harness nearby, exact in single precision.
Eigen::Vector3d originOf(const CableShape& shape) {
  return shape.points.front().pose.position.array().round().matrix();
}

/// From 0 to the largest value of all cables.
void setRanges(CableTubes& tubes) {
  for (std::size_t i = 0; !tubes.cables.empty() && i < tubes.cables.front().quantities.size(); ++i) {
    float largest = 0.0F;
    for (const CableTube& tube : tubes.cables) {
      for (const float value : tube.quantities[i].values) largest = std::max(largest, value);
    }
    for (CableTube& tube : tubes.cables) tube.quantities[i].maximum = largest;
  }
}

bool inSamePlace(const CableTube& a, const CableTube& b, const Eigen::Vector3d& shift) {
  if (a.cable != b.cable || a.position.size() != b.position.size()) return false;
  for (std::size_t i = 0; i < a.position.size(); ++i) {
    if (!(std::abs(a.position[i] - (b.position[i] + shift[static_cast<Eigen::Index>(i % 3)])) < kSamePlace)) {
      return false;
    }
  }
  return true;
}

Eigen::Vector3d originOf(const CableTubes& tubes) { return {tubes.origin.x, tubes.origin.y, tubes.origin.z}; }

}  // namespace

CableTubes cableTubes(const Equilibrium& equilibrium, const Harness& harness, bool outdated) {
  if (!equilibrium.converged() || equilibrium.shapes.empty()) return inWorld(Eigen::Vector3d::Zero());
  CableTubes tubes = inWorld(originOf(equilibrium.shapes.front()));
  tubes.outdated = outdated;
  for (std::size_t i = 0; i < equilibrium.shapes.size(); ++i) {
    const CableShape& shape = equilibrium.shapes[i];
    const Cable& cable = harness.cables[i];
    CableTube tube = tubeOf(shape, cable, stepOf(harness), originOf(tubes));
    addQuantity(tube, quantityCalled(kCurvatureQuantity, "1/m"), cable.length,
                [&](double s) { return valueAt(shape, s, curvatureOf); });
    addQuantity(tube, quantityCalled(kStrainQuantity, "%"), cable.length, [&](double s) {
      const double bending = sectionAt(cable, s).radius * valueAt(shape, s, bendingOf);
      return 100.0 * (valueAt(shape, s, stretchOf) + bending);
    });
    addQuantity(tube, quantityCalled(kForceQuantity, "N"), cable.length,
                [&](double s) { return valueAt(shape, s, forceOf); });
    tubes.cables.push_back(std::move(tube));
  }
  setRanges(tubes);
  return tubes;
}

CableQuantity variationQuantity(const cable_variation::Legend& legend) {
  CableQuantity quantity = quantityCalled(kVariationQuantity, legend.unit.c_str());
  quantity.minimum = static_cast<float>(legend.minimum);
  quantity.maximum = static_cast<float>(legend.maximum);
  return quantity;
}

CableTubes valuedTubes(const Equilibrium& equilibrium, const Harness& harness, const CableQuantity& quantity,
                       const std::map<std::size_t, std::function<double(double)>>& values) {
  if (values.empty()) return inWorld(Eigen::Vector3d::Zero());
  CableTubes tubes = inWorld(originOf(equilibrium.shapes.front()));
  for (const auto& [i, value] : values) {
    CableTube tube = tubeOf(equilibrium.shapes[i], harness.cables[i], stepOf(harness), originOf(tubes));
    addQuantity(tube, quantity, harness.cables[i].length, value);
    tubes.cables.push_back(std::move(tube));
  }
  return tubes;
}

void addValues(CableTubes& tubes, const CableTubes& values) {
  if (tubes.outdated) return;
  const Eigen::Vector3d shift = originOf(values) - originOf(tubes);
  const std::size_t count = tubes.cables.size();
  for (const CableTube& valued : values.cables) {
    const auto end = tubes.cables.begin() + static_cast<std::ptrdiff_t>(count);
    const auto found = std::find_if(tubes.cables.begin(), end,
                                    [&](const CableTube& tube) { return inSamePlace(tube, valued, shift); });
    if (found != end) {
      found->quantities.insert(found->quantities.end(), valued.quantities.begin(), valued.quantities.end());
      continue;
    }
    CableTube elsewhere = valued;
    elsewhere.elsewhere = true;
    for (std::size_t i = 0; i < elsewhere.position.size(); ++i) {
      elsewhere.position[i] += static_cast<float>(shift[static_cast<Eigen::Index>(i % 3)]);
    }
    tubes.cables.push_back(std::move(elsewhere));
  }
}

}  // namespace cable_variation_ros
