#include <cable_variation/equilibrium/derivatives/equilibrium_rate.h>

#include <algorithm>
#include <array>
#include <cmath>

#include <cable_variation/equilibrium/discretisation/equilibrium_result.h>
#include <cable_variation/equilibrium/discretisation/shape_point.h>

namespace cable_variation {
namespace {

Eigen::VectorXd arcLengthRates(const Harness& harness, const Topology& topology, const HarnessRate& rate) {
  Eigen::VectorXd rates = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(topology.stations.size()));
  const auto at = [&](std::size_t station) -> double& { return rates[static_cast<Eigen::Index>(station)]; };
  for (const CableRate& cable : rate.cables) {
    const auto& stations = topology.cable_stations[cable.cable];
    for (std::size_t station : stations) {
      const Station& s = topology.stations[station];
      const bool is_joint_parent = std::find(topology.joint_parent.begin(), topology.joint_parent.end(),
                                             station) != topology.joint_parent.end();
      if (s.clip || s.joint || is_joint_parent || !s.loads.empty()) continue;
      at(station) = cable.knots * s.arc_length;  // a step of the section
    }
    at(stations.back()) = cable.length;
    at(stations.front()) = 0.0;
  }
  for (const auto& [clip, value] : rate.clip_arc_lengths) {
    const Clip& held = harness.clips[clip];
    if (held.attached && !held.constraint.slides) at(topology.clip_station[clip]) = value;
  }
  for (const auto& [joint, value] : rate.parent_arc_lengths) at(topology.joint_parent[joint]) = value;
  for (const auto& [joint, value] : rate.child_arc_lengths) at(topology.joint_child[joint]) = value;
  for (const auto& [load, value] : rate.load_arc_lengths) {
    for (std::size_t i = 0; i < topology.stations.size(); ++i) {
      const auto& loads = topology.stations[i].loads;
      if (std::find(loads.begin(), loads.end(), load) != loads.end()) at(i) = value;
    }
  }
  return rates;
}

}  // namespace

HarnessChange changeOf(const Harness& harness, const Topology& topology, const StationUnknowns& unknowns,
                       const Configuration& configuration, const HarnessRate& rate) {
  const auto count = static_cast<Eigen::Index>(topology.stations.size());
  HarnessChange change;
  change.carried.setZero(6, count);
  change.frame_turn.setZero(3, count);
  change.cables = rate.cables;
  change.parts = rate.part_frames;
  change.arc_lengths = arcLengthRates(harness, topology, rate);
  for (std::size_t i = 0; i < topology.stations.size(); ++i) {
    if (unknowns.slide(i) >= 0) change.arc_lengths[static_cast<Eigen::Index>(i)] = 0.0;
  }
  for (const auto& [clip, frame] : rate.clip_frames) {
    const std::size_t station = topology.clip_station[clip];
    if (station == kNoStation) continue;
    const auto column = static_cast<Eigen::Index>(station);
    const Pose& pose = configuration.stations[station].pose;
    const ClipConstraint& constraint = harness.clips[clip].constraint;
    change.frame_turn.col(column) = frame.rotation;
    if (constraint.holdsPosition()) {
      change.carried.col(column).head<3>() =
          frame.translation + frame.rotation.cross(pose.position - harness.clips[clip].pose.position);
    }
    if (constraint.holdsRotation()) {
      change.carried.col(column).tail<3>() = pose.orientation.conjugate() * frame.rotation;
    }
  }
  for (std::size_t i : topology.order) {
    const Station& station = topology.stations[i];
    if (!station.joint) continue;
    const auto child = static_cast<Eigen::Index>(i), parent = static_cast<Eigen::Index>(*station.parent);
    change.frame_turn.col(child) = change.frame_turn.col(parent);
    change.carried.col(child).head<3>() = change.carried.col(parent).head<3>();
    if (harness.joints[*station.joint].type == Joint::Type::pivot) continue;
    const Eigen::Quaterniond relative = configuration.stations[i].pose.orientation.conjugate() *
                                        configuration.stations[*station.parent].pose.orientation;
    change.carried.col(child).tail<3>() = relative * change.carried.col(parent).tail<3>();
  }
  return change;
}

double sizeOf(const HarnessChange& change, const HarnessResponse& response, double length) {
  double size = response.arc_lengths.cwiseAbs().maxCoeff() / length;
  for (const auto& nodes : response.motion.spans) {
    size = std::max({size, nodes.topRows<3>().cwiseAbs().maxCoeff() / length,
                     nodes.bottomRows<3>().cwiseAbs().maxCoeff()});
  }
  for (const CableRate& cable : change.cables) {
    size = std::max({size, cable.stiffness.cwiseAbs().maxCoeff(), std::abs(cable.mass),
                     std::abs(cable.rest_curvature), std::abs(cable.radius), std::abs(cable.knots) * length});
  }
  return size;
}

ShapeRates::ShapeRates(const Harness& harness, const Topology& topology,
                       const std::vector<CableShape>& shapes)
    : harness_(harness), topology_(topology), shapes_(shapes) {
  for (std::size_t c = 0; c < shapes.size(); ++c) {
    const RodProfile profile(harness.cables[c]);
    const auto& points = shapes[c].points;
    std::vector<RodProperties>& properties = properties_.emplace_back();
    std::size_t last = 0;
    for (std::size_t first = 0; first < points.size(); first = last + 1) {
      // a span's points rise; the next one starts where it ends
      for (last = first; last + 1 < points.size() && points[last + 1].arc_length > points[last].arc_length;)
        ++last;
      const double start = points[first].arc_length, length = points[last].arc_length - start;
      for (std::size_t i = first; i <= last; ++i) {
        properties.push_back(profile.at(insideSpan(points[i].arc_length, start, length)));
      }
    }
  }
}

EquilibriumRate ShapeRates::of(const HarnessChange& change, const HarnessResponse& response) const {
  EquilibriumRate rate;
  rate.elastic_energy = response.elastic_energy;
  std::vector<std::array<Wrench, 2>> ends(topology_.spans.size());
  for (std::size_t c = 0; c < shapes_.size(); ++c) {
    CableRate cable;
    for (const CableRate& each : change.cables) {
      if (each.cable == c) cable = each;
    }
    std::vector<ShapePointRate>& points = rate.shapes.emplace_back();
    points.reserve(shapes_[c].points.size());
    for (std::size_t index : topology_.cable_spans[c]) {
      const Span& span = topology_.spans[index];
      const double left_rate = response.arc_lengths[static_cast<Eigen::Index>(span.left)];
      const double right_rate = response.arc_lengths[static_cast<Eigen::Index>(span.right)];
      const auto& forces = response.section_forces[index];
      const auto boundaries = static_cast<std::size_t>(forces.cols());
      const ShapePoint* const first = &shapes_[c].points[points.size()];
      const double left = first->arc_length;
      const double length = first[boundaries - 1].arc_length - left;
      for (std::size_t k = 0; k < boundaries; ++k) {
        const auto column = static_cast<Eigen::Index>(k);
        const ShapePoint& point = first[k];
        const double share = (point.arc_length - left) / length;
        const double moved = left_rate + share * (right_rate - left_rate);
        const RodProperties& rod = properties_[c][points.size()];
        points.push_back(shapePointRate(point, response.motion.spans[index].col(3 * column),
                                        forces.col(column), moved, rod,
                                        propertyRate(rod, point.arc_length, cable, moved), harness_.gravity));
      }
      const Vector6d left_force = forces.col(0), right_force = forces.col(forces.cols() - 1);
      ends[index] = {Wrench{-left_force.head<3>(), -left_force.tail<3>()},
                     Wrench{right_force.head<3>(), right_force.tail<3>()}};
    }
  }
  const std::vector<Wrench> wrenches =
      stationWrenches(topology_, ends, std::vector<Wrench>(topology_.stations.size()));
  for (std::size_t station : topology_.clip_station) {
    if (station == kNoStation) {
      rate.clip_reactions.emplace_back();
      continue;
    }
    rate.clip_reactions.push_back({wrenches[station].force, wrenches[station].moment,
                                   response.arc_lengths[static_cast<Eigen::Index>(station)]});
  }
  return rate;
}

}  // namespace cable_variation
