#include <cable_variation/import/cable_paths.h>

#include <algorithm>
#include <limits>
#include <map>
#include <numeric>
#include <optional>

namespace cable_variation {
namespace {

constexpr std::size_t kNone = static_cast<std::size_t>(-1);

// Ends of segments are numbered: 2 i is the start of segment i, 2 i + 1 its end.
std::size_t otherEnd(std::size_t end) { return end ^ 1U; }

std::size_t nodeOf(const SegmentGraph& graph, std::size_t end) {
  const SegmentGraph::Edge& edge = graph.edges[end / 2];
  return end % 2 == 0 ? edge.start_node : edge.end_node;
}

// Away from the node.
Eigen::Vector3d directionOf(const SegmentGraph& graph, std::size_t end) {
  const SegmentGraph::Edge& edge = graph.edges[end / 2];
  return end % 2 == 0 ? edge.start_tangent : Eigen::Vector3d(-edge.end_tangent);
}

std::vector<std::vector<std::size_t>> endsByNode(const SegmentGraph& graph) {
  std::vector<std::vector<std::size_t>> ends(graph.nodes);
  for (std::size_t end = 0; end < 2 * graph.edges.size(); ++end) ends[nodeOf(graph, end)].push_back(end);
  return ends;
}

struct Pair {
  double score;
  std::size_t a, b;
};

// How segments run on: per end, the end it goes on with, or kNone.
std::vector<std::size_t> throughGoing(const SegmentGraph& graph) {
  std::vector<std::size_t> next(2 * graph.edges.size(), kNone);
  std::vector<Pair> pairs;
  constexpr std::size_t kMost = 100;  // of a node's ends that are looked at, the thickest ones
  std::vector<std::vector<std::size_t>> ends_at = endsByNode(graph);
  for (std::vector<std::size_t>& ends : ends_at) {
    if (ends.size() > kMost) {
      std::stable_sort(ends.begin(), ends.end(), [&](std::size_t a, std::size_t b) {
        return graph.edges[a / 2].thickness > graph.edges[b / 2].thickness;
      });
      ends.resize(kMost);
    }
    for (std::size_t j = 1; j < ends.size(); ++j) {
      for (std::size_t i = 0; i < j; ++i) {
        const std::size_t a = ends[i], b = ends[j];
        const double cosine = -directionOf(graph, a).dot(directionOf(graph, b));
        if (!(cosine >= 0.0)) continue;
        const double thinner = std::min(graph.edges[a / 2].thickness, graph.edges[b / 2].thickness);
        pairs.push_back({0.5 * thinner * (1.0 + cosine), a, b});
      }
    }
  }
  std::stable_sort(pairs.begin(), pairs.end(),
                   [](const Pair& x, const Pair& y) { return x.score > y.score; });
  const auto farEnd = [&](std::size_t end) {
    for (end = otherEnd(end); next[end] != kNone; end = otherEnd(next[end])) {
    }
    return end;
  };
  std::vector<bool> passed(graph.nodes, false);
  for (const Pair& pair : pairs) {
    const std::size_t node = nodeOf(graph, pair.a);
    if (passed[node]) continue;
    if (nodeOf(graph, farEnd(pair.a)) == nodeOf(graph, farEnd(pair.b))) continue;
    next[pair.a] = pair.b;
    next[pair.b] = pair.a;
    passed[node] = true;
  }
  return next;
}

// A graph's parts by union and find.
class Parts {
 public:
  explicit Parts(std::size_t count) : above_(count) { std::iota(above_.begin(), above_.end(), 0); }
  std::size_t find(std::size_t i) {
    while (above_[i] != i) i = above_[i] = above_[above_[i]];
    return i;
  }
  bool join(std::size_t a, std::size_t b) {
    const std::size_t x = find(a), y = find(b);
    above_[std::max(x, y)] = std::min(x, y);
    return x != y;
  }

 private:
  std::vector<std::size_t> above_;
};

}  // namespace

CablePaths cablePaths(const SegmentGraph& graph) {
  CablePaths result;
  const std::vector<std::size_t> next = throughGoing(graph);
  struct Place {
    std::size_t path, before;  // parts of the path before it
  };
  std::vector<Place> of_end(next.size(), {kNone, 0});
  for (std::size_t begin = 0; begin < next.size(); ++begin) {
    if (next[begin] != kNone || of_end[begin].path != kNone) continue;
    const std::size_t index = result.paths.size();
    CablePath path;
    for (std::size_t end = begin;; end = next[otherEnd(end)]) {
      of_end[end] = {index, path.parts.size()};
      path.parts.push_back({end / 2, end % 2 == 1});
      of_end[otherEnd(end)] = {index, path.parts.size()};
      if (next[otherEnd(end)] == kNone) break;
    }
    result.paths.push_back(std::move(path));
  }
  const std::vector<std::vector<std::size_t>> ends_at = endsByNode(graph);
  for (std::size_t node = 0; node < graph.nodes; ++node) {
    const std::vector<std::size_t>& ends = ends_at[node];
    if (ends.size() < 2) continue;
    const auto runs_on =
        std::find_if(ends.begin(), ends.end(), [&](std::size_t end) { return next[end] != kNone; });
    const auto parent = runs_on != ends.end()
                            ? *runs_on
                            : *std::max_element(ends.begin(), ends.end(), [&](std::size_t a, std::size_t b) {
                                return graph.edges[a / 2].thickness < graph.edges[b / 2].thickness;
                              });
    for (const std::size_t end : ends) {
      if (end == parent || next[end] != kNone) continue;
      result.joints.push_back(
          {node, of_end[parent].path, of_end[parent].before, of_end[end].path, of_end[end].before != 0});
    }
  }
  return result;
}

std::vector<std::vector<std::size_t>> connectedSegments(const SegmentGraph& graph) {
  Parts parts(graph.nodes);
  for (const SegmentGraph::Edge& edge : graph.edges) parts.join(edge.start_node, edge.end_node);
  std::map<std::size_t, std::size_t> order;
  std::vector<std::vector<std::size_t>> segments;
  for (std::size_t i = 0; i < graph.edges.size(); ++i) {
    const auto [place, is_new] = order.emplace(parts.find(graph.edges[i].start_node), segments.size());
    if (is_new) segments.emplace_back();
    segments[place->second].push_back(i);
  }
  return segments;
}

std::vector<std::size_t> closingSegments(const SegmentGraph& graph) {
  Parts parts(graph.nodes);
  std::vector<std::size_t> closing;
  for (std::size_t i = 0; i < graph.edges.size(); ++i) {
    if (!parts.join(graph.edges[i].start_node, graph.edges[i].end_node)) closing.push_back(i);
  }
  return closing;
}

std::vector<std::size_t> ringOf(const SegmentGraph& graph, std::size_t closing) {
  // breadth first from one of its nodes to the other, along segments before it
  const std::size_t from = graph.edges[closing].start_node, to = graph.edges[closing].end_node;
  const std::vector<std::vector<std::size_t>> ends_at = endsByNode(graph);
  std::vector<std::size_t> by(graph.nodes, kNone);  // the segment that a node was reached by
  std::vector<bool> reached(graph.nodes, false);
  std::vector<std::size_t> nodes{from};
  reached[from] = true;
  for (std::size_t next = 0; next < nodes.size() && !reached[to]; ++next) {
    for (const std::size_t end : ends_at[nodes[next]]) {
      const std::size_t beyond = nodeOf(graph, otherEnd(end));
      if (end / 2 >= closing || reached[beyond]) continue;
      reached[beyond] = true;
      by[beyond] = end / 2;
      nodes.push_back(beyond);
    }
  }
  std::vector<std::size_t> ring{closing};
  for (std::size_t node = to; node != from && by[node] != kNone;) {
    ring.push_back(by[node]);
    const SegmentGraph::Edge& edge = graph.edges[by[node]];
    node = edge.start_node == node ? edge.end_node : edge.start_node;
  }
  return ring;
}

}  // namespace cable_variation
