#include <cable_variation/equilibrium/search/meeting_points.h>

#include <algorithm>

namespace cable_variation {
namespace {

struct Edge {
  std::size_t a, b;  // stations
  double length;     // [m]
};

struct Graph {
  std::vector<bool> is_point;  // per station
  std::vector<bool> is_fixed;
  std::vector<Edge> edges;
};

Graph makeGraph(const Harness& harness, const Topology& topology, const Configuration& configuration) {
  Graph graph;
  const std::size_t count = topology.stations.size();
  graph.is_point.assign(count, false);
  graph.is_fixed.assign(count, false);
  for (std::size_t i = 0; i < count; ++i) {
    const Station& station = topology.stations[i];
    graph.is_fixed[i] = station.clip && harness.clips[*station.clip].constraint.holdsPosition();
    graph.is_point[i] = graph.is_fixed[i];
  }
  for (const std::size_t parent : topology.joint_parent) graph.is_point[parent] = true;
  for (const std::vector<std::size_t>& stations : topology.cable_stations) {
    std::optional<std::size_t> before;  // as a point
    double arc_length = 0.0;
    for (const std::size_t index : stations) {
      const auto& parent = topology.stations[index].parent;
      const std::size_t point = parent ? *parent : index;  // a child's end is where its parent is
      if (!graph.is_point[point]) continue;
      const double here = configuration.stations[index].arc_length;
      if (before && *before != point) graph.edges.push_back({*before, point, here - arc_length});
      before = point;
      arc_length = here;
    }
  }
  return graph;
}

// Drops movable points that hang on one piece of cable only, with the piece, until there are none.
void prune(Graph& graph) {
  for (bool changed = true; changed;) {
    changed = false;
    std::vector<int> degree(graph.is_point.size(), 0);
    for (const Edge& edge : graph.edges) {
      ++degree[edge.a];
      ++degree[edge.b];
    }
    for (std::size_t i = 0; i < degree.size(); ++i) {
      if (!graph.is_point[i] || graph.is_fixed[i] || degree[i] > 1) continue;
      graph.is_point[i] = false;
      changed = true;
    }
    const auto gone = [&](const Edge& edge) { return !graph.is_point[edge.a] || !graph.is_point[edge.b]; };
    graph.edges.erase(std::remove_if(graph.edges.begin(), graph.edges.end(), gone), graph.edges.end());
  }
}

}  // namespace

std::vector<std::optional<Eigen::Vector3d>> meetingPoints(const Harness& harness, const Topology& topology,
                                                          const Configuration& configuration) {
  constexpr int kSweeps = 200;
  constexpr double kDrawn = 0.95;  // of its length: a piece is drawn out no further
  const std::size_t count = topology.stations.size();
  std::vector<std::optional<Eigen::Vector3d>> points(count);
  if (topology.joint_parent.empty()) return points;
  Graph graph = makeGraph(harness, topology, configuration);
  prune(graph);

  std::vector<Eigen::Vector3d> at(count, Eigen::Vector3d::Zero());
  Eigen::Vector3d middle = Eigen::Vector3d::Zero();
  double fixed = 0.0;
  for (std::size_t i = 0; i < count; ++i) {
    if (!graph.is_fixed[i]) continue;
    at[i] = configuration.stations[i].pose.position;
    middle += at[i];
    fixed += 1.0;
  }
  if (fixed == 0.0) return points;
  const auto moves = [&](std::size_t i) { return graph.is_point[i] && !graph.is_fixed[i]; };
  for (std::size_t i = 0; i < count; ++i) {
    if (moves(i)) at[i] = middle / fixed;
  }
  for (int sweep = 0; sweep < kSweeps; ++sweep) {  // strings in balance
    std::vector<Eigen::Vector3d> sum(count, Eigen::Vector3d::Zero());
    std::vector<double> weight(count, 0.0);
    for (const Edge& edge : graph.edges) {
      const double tension = 1.0 / std::max(edge.length, 1e-9);
      sum[edge.a] += tension * at[edge.b];
      sum[edge.b] += tension * at[edge.a];
      weight[edge.a] += tension;
      weight[edge.b] += tension;
    }
    for (std::size_t i = 0; i < count; ++i) {
      if (moves(i) && weight[i] > 0.0) at[i] = sum[i] / weight[i];
    }
  }
  for (int sweep = 0; sweep < kSweeps; ++sweep) {  // no piece too long
    for (const Edge& edge : graph.edges) {
      const Eigen::Vector3d way = at[edge.b] - at[edge.a];
      const double excess = way.norm() - kDrawn * edge.length;
      const int movable = (moves(edge.a) ? 1 : 0) + (moves(edge.b) ? 1 : 0);
      if (excess <= 0.0 || movable == 0) continue;
      const Eigen::Vector3d push = excess / movable * way.normalized();
      if (moves(edge.a)) at[edge.a] += push;
      if (moves(edge.b)) at[edge.b] -= push;
    }
  }
  for (std::size_t i = 0; i < count; ++i) {
    if (moves(i)) points[i] = at[i];
  }
  return points;
}

}  // namespace cable_variation
