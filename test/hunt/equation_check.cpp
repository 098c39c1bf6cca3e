#include <algorithm>

#include <hunt/balance_check.h>
#include <hunt/rod_integration.h>
#include <hunt/rotation.h>

namespace cable_variation::hunt {

using Eigen::Vector3d;

namespace {

RodState stateAt(const ShapePoint& point) {
  return {point.pose.position, point.pose.orientation, point.force, point.moment};
}

}  // namespace

// From one point to the next an error grows little, unlike from one end of a long cable to the other.
Violation checkEquations(const Harness& harness, const Equilibrium& answer, double accuracy) {
  // of the largest: forces change by the weight alone, moments depend on the centreline between
  constexpr double kForce = 3e-5, kMoment = 5e-3;
  Violation violation;
  double largest_force = 1e-12, largest_moment = 1e-15;
  for (const CableShape& shape : answer.shapes) {
    for (const ShapePoint& point : shape.points) {
      largest_force = std::max(largest_force, point.force.norm());
      largest_moment = std::max(largest_moment, point.moment.norm());
    }
  }
  for (std::size_t c = 0; c < harness.cables.size(); ++c) {
    const Cable& cable = harness.cables[c];
    const RodProfile profile(cable);
    const auto& points = answer.shapes[c].points;
    const Section& section = cable.sections.front().section;
    const double force =
        std::max(largest_force, std::min(section.EI_y, section.EI_z) / (cable.length * cable.length));
    const double moment = std::max(largest_moment, std::min(section.EI_y, section.EI_z) / cable.length);
    for (std::size_t i = 1; i < points.size(); ++i) {
      const ShapePoint &a = points[i - 1], &b = points[i];
      const double h = b.arc_length - a.arc_length;
      if (h <= 1e-9 * cable.length) continue;
      const double middle = a.arc_length + 0.5 * h;
      const RodState half = integrateRod(profile, harness.gravity, stateAt(a), a.arc_length, middle);
      const RodState end = integrateRod(profile, harness.gravity, half, middle, b.arc_length);
      const std::string where = " between " + std::to_string(1e3 * a.arc_length) + " and " +
                                std::to_string(1e3 * b.arc_length) + " mm of '" + cable.name + "'";
      violation.worst((answer.shapes[c].position(middle) - half.position).norm(), 2.0 * accuracy,
                      "centreline leaves the rod's equations" + where);
      violation.worst((b.pose.position - end.position).norm(), 2.0 * accuracy,
                      "position leaves the rod's equations" + where);
      const double turn = rotationVector(b.pose.orientation.conjugate() * end.orientation).norm();
      violation.worst(turn * h, 4.0 * accuracy, "orientation leaves the rod's equations" + where);
      violation.worst((b.force - end.force).norm(), kForce * force,
                      "force leaves the rod's equations" + where);
      // a bow of the accuracy asked for is a curvature of 8 times it over h²
      const double bow = 8.0 * accuracy / (h * h) * std::min(section.EI_y, section.EI_z);
      violation.worst((b.moment - end.moment).norm(), kMoment * moment + bow,
                      "moment leaves the rod's equations" + where);
    }
  }
  return violation;
}

}  // namespace cable_variation::hunt
