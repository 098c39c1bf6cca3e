#include <cable_variation/equilibrium/discretisation/configuration.h>

#include <algorithm>

#include <cable_variation/math/so3.h>

namespace cable_variation {

void placeStations(const Harness& harness, const Topology& topology, Configuration& configuration) {
  for (std::size_t index : topology.order) {
    const Station& station = topology.stations[index];
    StationConfiguration& at = configuration.stations[index];
    if (station.clip) {
      const Clip& clip = harness.clips[*station.clip];
      if (clip.constraint.holdsPosition()) at.pose.position = clip.pose * at.offset;
      if (clip.constraint.holdsRotation()) {
        at.pose.orientation = clip.pose.orientation * so3::exp(at.rotation);
      }
    }
    if (station.joint) {
      const Joint& joint = harness.joints[*station.joint];
      const Pose& parent = configuration.stations[*station.parent].pose;
      at.pose.position = parent.position;
      if (joint.type == Joint::Type::fixed) at.pose.orientation = parent.orientation * joint.rotation;
      if (joint.type == Joint::Type::hinge) {
        at.pose.orientation = parent.orientation * joint.rotation * so3::exp(at.hinge_angle * joint.axis);
      }
    }
    at.pose.orientation.normalize();
  }
  for (std::size_t i = 0; i < topology.spans.size(); ++i) {
    SpanConfiguration& span = configuration.spans[i];
    if (span.positions.empty()) continue;
    const Pose& left = configuration.stations[topology.spans[i].left].pose;
    const Pose& right = configuration.stations[topology.spans[i].right].pose;
    span.positions.front() = left.position;
    span.orientations.front() = left.orientation;
    span.positions.back() = right.position;
    span.orientations.back() = right.orientation;
  }
}

double largestArcLength(const Configuration& configuration) {
  double largest = 0.0;
  for (const StationConfiguration& station : configuration.stations) {
    largest = std::max(largest, station.arc_length);
  }
  return largest;
}

}  // namespace cable_variation
