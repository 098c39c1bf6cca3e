#include <cable_variation/harness/equilibrium_result.h>

#include <algorithm>
#include <sstream>

#include <cable_variation/harness/grid.h>
#include <cable_variation/rod/profile.h>

namespace cable_variation {
namespace {

// A section from its pose and the force and moment there: strains by the
// material law, φ'' by differentiating φ' = R Γ with the force balance.
ShapePoint shapePoint(double arc_length, const Pose& pose, const Vector6d& section_force,
                      const RodProperties& rod, const Eigen::Vector3d& gravity) {
  ShapePoint point;
  point.arc_length = arc_length;
  point.pose = pose;
  point.force = section_force.head<3>();
  const Eigen::Vector3d m = section_force.tail<3>();
  point.moment = pose.orientation * m;
  const Eigen::Vector3d n = pose.orientation.conjugate() * point.force;
  const Eigen::Vector3d k_gamma = rod.stiffness.head<3>();
  const Eigen::Vector3d k_omega = rod.stiffness.tail<3>();
  point.strain = n.cwiseQuotient(k_gamma);
  point.curvature = m.cwiseQuotient(k_omega);
  point.turn = point.curvature + rod.rest_curvature;
  const Eigen::Vector3d gamma = Eigen::Vector3d::UnitX() + point.strain;
  point.tangent = pose.orientation * gamma;
  // n' in the section frame: -Ω × n - ρA Rᵀg; stiffness may change along s
  const Eigen::Vector3d weight = pose.orientation.conjugate() * (rod.mass_per_length * gravity);
  const Eigen::Vector3d n_slope = -point.turn.cross(n) - weight;
  const Eigen::Vector3d stiffness_slope = rod.stiffness_slope.head<3>();
  const Eigen::Vector3d gamma_slope =
      (n_slope - stiffness_slope.cwiseProduct(point.strain)).cwiseQuotient(k_gamma);
  point.bend = pose.orientation * (point.turn.cross(gamma) + gamma_slope);
  return point;
}

CableShape describeCable(const Harness& harness, const Topology& topology, const RodSystem& system,
                         const Configuration& configuration, std::size_t cable) {
  CableShape shape;
  shape.cable = harness.cables[cable].name;
  for (const SectionAt& at : harness.cables[cable].sections)
    shape.radius = std::max(shape.radius, at.section.radius);
  const RodProfile profile(harness.cables[cable]);
  for (std::size_t index : topology.cable_spans[cable]) {
    const Span& span = topology.spans[index];
    const double left = configuration.stations[span.left].arc_length;
    const double length = configuration.stations[span.right].arc_length - left;
    const auto& boundaries = system.grid()[index];
    const SpanConfiguration& nodes = configuration.spans[index];
    for (std::size_t k = 0; k < boundaries.size(); ++k) {
      const double s = left + boundaries[k] * length;
      // at a step of the section, this span's side of it
      const double inside = std::clamp(s, left + 1e-9 * length, left + (1.0 - 1e-9) * length);
      shape.points.push_back(shapePoint(s, {nodes.positions[3 * k], nodes.orientations[3 * k]},
                                        system.sectionForce(index, k), profile.at(inside), harness.gravity));
    }
  }
  return shape;
}

}  // namespace

std::vector<CableShape> describeShapes(const Harness& harness, const Topology& topology,
                                       const RodSystem& system, const Configuration& configuration) {
  std::vector<CableShape> shapes;
  for (std::size_t c = 0; c < harness.cables.size(); ++c) {
    shapes.push_back(describeCable(harness, topology, system, configuration, c));
  }
  return shapes;
}

Configuration onGrid(const Topology& topology, const Configuration& configuration,
                     const std::vector<CableShape>& shapes, const Grid& grid) {
  Configuration result;
  result.stations = configuration.stations;
  result.spans.resize(grid.size());
  for (std::size_t i = 0; i < grid.size(); ++i) {
    const Span& span = topology.spans[i];
    const StationConfiguration& left = configuration.stations[span.left];
    const StationConfiguration& right = configuration.stations[span.right];
    SpanConfiguration& nodes = result.spans[i];
    const auto put = [&](const Pose& pose) {
      nodes.positions.push_back(pose.position);
      nodes.orientations.push_back(pose.orientation);
    };
    put(left.pose);
    for (std::size_t e = 0; e + 1 < grid[i].size(); ++e) {
      for (int a = 1; a < element::kNodes; ++a) {
        const double fraction = grid[i][e] + element::kNodeAt[a] * (grid[i][e + 1] - grid[i][e]);
        const bool last = e + 2 == grid[i].size() && a == element::kNodes - 1;
        put(last
                ? right.pose
                : shapes[span.cable].pose(left.arc_length + fraction * (right.arc_length - left.arc_length)));
      }
    }
  }
  return result;
}

void describe(const Harness& harness, const Topology& topology, const RodSystem& system,
              const Configuration& configuration, Equilibrium& result) {
  result.energy = system.energy();
  result.residual = system.residual();
  result.shapes = describeShapes(harness, topology, system, configuration);
  // What the cables need from outside at each station: what its spans need, less the loads there,
  // plus what the children that hang on it need.
  struct Need {
    Eigen::Vector3d force = Eigen::Vector3d::Zero();
    Eigen::Vector3d moment = Eigen::Vector3d::Zero();
  };
  std::vector<Need> needs(topology.stations.size());
  for (std::size_t i = 0; i < topology.spans.size(); ++i) {
    for (int end = 0; end < 2; ++end) {
      const std::size_t station = end == 0 ? topology.spans[i].left : topology.spans[i].right;
      const Vector6d force = system.endForce(i, end);
      needs[station].force += force.head<3>();
      needs[station].moment += configuration.stations[station].pose.orientation * force.tail<3>();
    }
  }
  for (std::size_t i = 0; i < needs.size(); ++i) {
    for (std::size_t load : topology.stations[i].loads) {
      needs[i].force -= harness.loads[load].force;
      needs[i].moment -= harness.loads[load].moment;
    }
  }
  const auto reaction = [&](const std::string& name, std::size_t station) {
    Reaction r;
    r.name = name;
    r.force = needs[station].force;
    r.moment = needs[station].moment;
    r.arc_length = configuration.stations[station].arc_length;
    r.section = configuration.stations[station].pose;
    return r;
  };
  result.joint_reactions.assign(harness.joints.size(), {});
  for (auto i = topology.order.rbegin(); i != topology.order.rend(); ++i) {
    const Station& station = topology.stations[*i];
    if (!station.joint) continue;
    result.joint_reactions[*station.joint] = reaction(harness.joints[*station.joint].name, *i);
    needs[*station.parent].force += needs[*i].force;
    needs[*station.parent].moment += needs[*i].moment;
  }
  result.clip_reactions.clear();
  for (std::size_t c = 0; c < harness.clips.size(); ++c) {
    result.clip_reactions.push_back(reaction(harness.clips[c].name, topology.clip_station[c]));
  }
}

double largestDistance(const Grid& grid_a, const Configuration& a, const Grid& grid_b,
                       const Configuration& b) {
  const Configuration on_a = transfer(b, grid_b, grid_a);
  double largest = 0.0;
  for (std::size_t i = 0; i < a.spans.size(); ++i) {
    for (std::size_t k = 0; k < a.spans[i].positions.size(); ++k) {
      largest = std::max(largest, (a.spans[i].positions[k] - on_a.spans[i].positions[k]).norm());
    }
  }
  return largest;
}

std::string unreachable(const Harness& harness, const Topology& topology, const Configuration& configuration,
                        double stretch) {
  const auto held = [&](const Station& station, bool must_not_slide) {
    if (!station.clip) return false;
    const ClipConstraint& constraint = harness.clips[*station.clip].constraint;
    return std::all_of(constraint.translation.begin(), constraint.translation.end(),
                       [](const ClipFreedom& f) { return f.kind == ClipFreedom::Kind::locked; }) &&
           !(must_not_slide && constraint.slides);
  };
  for (std::size_t c = 0; c < harness.cables.size(); ++c) {
    const Station* start = nullptr;
    double distance = 0.0;
    Eigen::Vector3d last = Eigen::Vector3d::Zero();
    for (std::size_t index : topology.cable_stations[c]) {
      const Station& station = topology.stations[index];
      if (!held(station, false)) continue;
      const Eigen::Vector3d here = configuration.stations[index].pose.position;
      if (start != nullptr) distance += (here - last).norm();
      last = here;
      if (!held(station, true)) continue;
      if (start != nullptr) {
        const double between = station.arc_length - start->arc_length;
        if (distance > (1.0 + stretch) * between) {
          std::ostringstream text;
          text << "clips '" << harness.clips[*start->clip].name << "' and '"
               << harness.clips[*station.clip].name << "' are " << 1e3 * distance << " mm apart, but only "
               << 1e3 * between << " mm of cable '" << harness.cables[c].name << "' lie between them";
          return text.str();
        }
      }
      start = &station;
      distance = 0.0;
    }
  }
  return {};
}

std::string whereItFailed(const Harness& harness, const Topology& topology, const RodSystem& system,
                          const Configuration& configuration) {
  constexpr double kNoRoom = 0.02;  // of the cable's length
  std::ostringstream text;
  for (const Span& span : topology.spans) {
    const double length =
        configuration.stations[span.right].arc_length - configuration.stations[span.left].arc_length;
    const Cable& cable = harness.cables[span.cable];
    if (length > kNoRoom * cable.length) continue;
    for (std::size_t index : {span.left, span.right}) {
      if (system.unknowns().slide(index) < 0) continue;
      text << "clip '" << harness.clips[*topology.stations[index].clip].name << "' slid to "
           << 1e3 * configuration.stations[index].arc_length << " mm of cable '" << cable.name
           << "', to the end of its room: expected it to come to rest before a cable's end, a clip, a joint, "
              "a load "
              "or a change of section";
      return text.str();
    }
  }
  const Span& span = topology.spans[system.worstSpan()];
  text << "cable '" << harness.cables[span.cable].name << "' is furthest from balance, between "
       << 1e3 * configuration.stations[span.left].arc_length << " and "
       << 1e3 * configuration.stations[span.right].arc_length << " mm";
  return text.str();
}

}  // namespace cable_variation
