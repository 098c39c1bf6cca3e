#include <cable_variation/equilibrium/discretisation/equilibrium_result.h>

#include <algorithm>
#include <sstream>

#include <cable_variation/equilibrium/discretisation/grid.h>
#include <cable_variation/equilibrium/discretisation/held_piece.h>
#include <cable_variation/equilibrium/discretisation/shape_point.h>
#include <cable_variation/equilibrium/discretisation/slide_room.h>
#include <cable_variation/rod/profile.h>

namespace cable_variation {

CableShape describeCable(const Harness& harness, const Topology& topology, const Grid& grid,
                         const std::vector<StationConfiguration>& stations, std::size_t cable,
                         const std::function<Boundary(std::size_t, std::size_t)>& at) {
  CableShape shape;
  shape.cable = harness.cables[cable].name;
  for (const SectionAt& section : harness.cables[cable].sections)
    shape.radius = std::max(shape.radius, section.section.radius);
  const RodProfile profile(harness.cables[cable]);
  for (std::size_t index : topology.cable_spans[cable]) {
    const Span& span = topology.spans[index];
    const double left = stations[span.left].arc_length;
    const double length = stations[span.right].arc_length - left;
    for (std::size_t k = 0; k < grid[index].size(); ++k) {
      const double s = left + grid[index][k] * length;
      const Boundary boundary = at(index, k);
      shape.points.push_back(shapePoint(s, boundary.pose, boundary.section_force,
                                        profile.at(insideSpan(s, left, length)), harness.gravity));
    }
  }
  return shape;
}

double insideSpan(double arc_length, double start, double length) {
  return std::clamp(arc_length, start + 1e-9 * length, start + (1.0 - 1e-9) * length);
}

std::vector<CableShape> describeShapes(const Harness& harness, const Topology& topology,
                                       const RodSystem& system, const Configuration& configuration) {
  std::vector<CableShape> shapes;
  for (std::size_t c = 0; c < harness.cables.size(); ++c) {
    shapes.push_back(describeCable(harness, topology, system.grid(), configuration.stations, c,
                                   [&](std::size_t span, std::size_t boundary) -> Boundary {
                                     const SpanConfiguration& nodes = configuration.spans[span];
                                     return {
                                         {nodes.positions[3 * boundary], nodes.orientations[3 * boundary]},
                                         system.sectionForce(span, boundary)};
                                   }));
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

std::vector<Wrench> stationWrenches(const Topology& topology,
                                    const std::vector<std::array<Wrench, 2>>& span_ends,
                                    const std::vector<Wrench>& loads) {
  std::vector<Wrench> wrenches(topology.stations.size());
  for (std::size_t i = 0; i < topology.spans.size(); ++i) {
    wrenches[topology.spans[i].left] += span_ends[i][0];
    wrenches[topology.spans[i].right] += span_ends[i][1];
  }
  for (std::size_t i = 0; i < wrenches.size(); ++i) {
    wrenches[i].force -= loads[i].force;
    wrenches[i].moment -= loads[i].moment;
  }
  for (auto i = topology.order.rbegin(); i != topology.order.rend(); ++i) {
    const Station& station = topology.stations[*i];
    if (station.parent) wrenches[*station.parent] += wrenches[*i];
  }
  return wrenches;
}

void describe(const Harness& harness, const Topology& topology, const RodSystem& system,
              const Configuration& configuration, Equilibrium& result) {
  result.energy = system.energy();
  result.residual = system.residual();
  std::vector<std::array<Vector6d, 2>> end_force;
  for (std::size_t i = 0; i < topology.spans.size(); ++i) {
    end_force.push_back({system.endForce(i, 0), system.endForce(i, 1)});
  }
  describeReactions(harness, topology, configuration.stations, end_force, result);
}

void describeReactions(const Harness& harness, const Topology& topology,
                       const std::vector<StationConfiguration>& stations,
                       const std::vector<std::array<Vector6d, 2>>& end_force, Equilibrium& result) {
  std::vector<std::array<Wrench, 2>> ends;
  for (std::size_t i = 0; i < topology.spans.size(); ++i) {
    ends.emplace_back();
    for (int end = 0; end < 2; ++end) {
      const std::size_t station = end == 0 ? topology.spans[i].left : topology.spans[i].right;
      const Vector6d& force = end_force[i][static_cast<std::size_t>(end)];
      ends.back()[static_cast<std::size_t>(end)] = {force.head<3>(),
                                                    stations[station].pose.orientation * force.tail<3>()};
    }
  }
  std::vector<Wrench> loads(topology.stations.size());
  for (std::size_t i = 0; i < loads.size(); ++i) {
    for (std::size_t load : topology.stations[i].loads) {
      loads[i] += {harness.loads[load].force, harness.loads[load].moment};
    }
  }
  const std::vector<Wrench> needs = stationWrenches(topology, ends, loads);
  const auto reaction = [&](const std::string& name, std::size_t station) {
    Reaction r;
    r.name = name;
    r.force = needs[station].force;
    r.moment = needs[station].moment;
    r.arc_length = stations[station].arc_length;
    r.section = stations[station].pose;
    return r;
  };
  result.joint_reactions.clear();
  for (std::size_t j = 0; j < harness.joints.size(); ++j) {
    result.joint_reactions.push_back(reaction(harness.joints[j].name, topology.joint_child[j]));
  }
  result.clip_reactions.clear();
  for (std::size_t c = 0; c < harness.clips.size(); ++c) {
    const Clip& clip = harness.clips[c];
    if (clip.attached) {
      result.clip_reactions.push_back(reaction(clip.name, topology.clip_station[c]));
      continue;
    }
    Reaction none;
    none.name = clip.name;
    none.arc_length = std::clamp(clip.arc_length, 0.0, harness.cables[clip.cable].length);
    if (clip.cable < result.shapes.size()) none.section = result.shapes[clip.cable].pose(none.arc_length);
    result.clip_reactions.push_back(none);
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
  for (const HeldPiece& piece : heldPieces(harness, topology, configuration)) {
    if (piece.distance <= (1.0 + stretch) * piece.length) continue;
    const auto clip = [&](std::size_t station) {
      return "'" + harness.clips[*topology.stations[station].clip].name + "'";
    };
    std::ostringstream text;
    text << "clips " << clip(piece.first) << " and " << clip(piece.last) << " are " << 1e3 * piece.distance
         << " mm apart, but only " << 1e3 * piece.length << " mm of cable '"
         << harness.cables[piece.cable].name << "' lie between them";
    return text.str();
  }
  return {};
}

std::string whereItFailed(const Harness& harness, const Topology& topology, const RodSystem& system,
                          const Configuration& configuration) {
  constexpr double kNoRoom = 4.0;  // times what a descent leaves of a span
  std::ostringstream text;
  for (const Span& span : topology.spans) {
    const double length =
        configuration.stations[span.right].arc_length - configuration.stations[span.left].arc_length;
    const Cable& cable = harness.cables[span.cable];
    if (length > kNoRoom * leastLength(harness, topology, span)) continue;
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
