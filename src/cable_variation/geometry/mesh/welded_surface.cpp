#include <cable_variation/geometry/mesh/welded_surface.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>
#include <unordered_map>

#include <Eigen/Geometry>

#include <cable_variation/geometry/mesh/box.h>
#include <cable_variation/geometry/mesh/triangle_tree.h>

namespace cable_variation {
namespace {

using Eigen::Vector3d;

constexpr double kCrackOfEdge = 0.25;  // a crack is no wider than this share of the edges beside it

struct Facet {
  Corners corners;
  std::uint32_t from;        // an index of the caller's
  bool was_doubled = false;  // there were more of it
};

std::vector<Corners> cornersOf(const std::vector<Facet>& facets) {
  std::vector<Corners> corners;
  corners.reserve(facets.size());
  for (const Facet& facet : facets) corners.push_back(facet.corners);
  return corners;
}

using OpenEdge = std::array<std::uint32_t, 2>;  // low, high

std::vector<OpenEdge> openEdges(const std::vector<Facet>& facets) {
  std::vector<OpenEdge> open;
  forEachEdge(edgesOf(cornersOf(facets)), [&](const FacetEdge* first, const FacetEdge* last) {
    if ((last - first) % 2 != 0) open.push_back({first->low, first->high});
  });
  return open;
}

// Those on open edges, ascending.
std::vector<std::uint32_t> verticesOf(const std::vector<OpenEdge>& edges) {
  std::vector<std::uint32_t> vertices;
  for (const OpenEdge& edge : edges) vertices.insert(vertices.end(), edge.begin(), edge.end());
  std::sort(vertices.begin(), vertices.end());
  vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
  return vertices;
}

// Points by cubes of a grid as wide as what is looked for.
class Cubes {
 public:
  explicit Cubes(double width) : width_(width) {}
  void add(std::uint32_t number, const Vector3d& at) { cubes_[key(cube(at))].push_back(number); }
  template <typename Visit>
  void forEachNear(const Vector3d& at, const Visit& visit) const {
    const Cube middle = cube(at);
    for (std::int64_t x = -1; x <= 1; ++x) {
      for (std::int64_t y = -1; y <= 1; ++y) {
        for (std::int64_t z = -1; z <= 1; ++z) {
          const auto found = cubes_.find(key({middle[0] + x, middle[1] + y, middle[2] + z}));
          if (found == cubes_.end()) continue;
          for (const std::uint32_t number : found->second) visit(number);
        }
      }
    }
  }

 private:
  using Cube = std::array<std::int64_t, 3>;
  Cube cube(const Vector3d& at) const {
    return {std::llround(at.x() / width_), std::llround(at.y() / width_), std::llround(at.z() / width_)};
  }
  // Cubes with the same key only make the search longer.
  static std::uint64_t key(const Cube& cube) {
    std::uint64_t mixed = 0;
    for (const std::int64_t along : cube) {
      mixed = (mixed ^ static_cast<std::uint64_t>(along)) * 0x9e3779b97f4a7c15ULL;
      mixed ^= mixed >> 29U;
    }
    return mixed;
  }

  double width_;
  std::unordered_map<std::uint64_t, std::vector<std::uint32_t>> cubes_;
};

class Mender {
 public:
  Mender(const std::vector<Vector3d>& vertices, double tolerance, bool cracks)
      : vertices_(vertices), tolerance_(tolerance), cracks_(cracks) {}

  // Vertices welded, flat facets and copies left out.
  std::vector<Facet> welded(std::vector<Facet> facets) const {
    weld(facets);
    const auto flat = [&](const Facet& facet) {
      return isCollapsed(facet.corners) || (!cracks_ && height(facet.corners) <= tolerance_);
    };
    facets.erase(std::remove_if(facets.begin(), facets.end(), flat), facets.end());
    if (!cracks_) dropCopies(facets);
    return facets;
  }

  // T-junctions closed, walls left out. A facet's `from` is its number among those given.
  std::vector<Facet> joined(const std::vector<Facet>& facets) const {
    std::vector<Facet> numbered = facets;
    for (std::uint32_t i = 0; i < numbered.size(); ++i) numbered[i].from = i;
    numbered = divided(numbered);
    if (!cracks_) dropWalls(numbered);
    return numbered;
  }

 private:
  double length(const OpenEdge& edge) const { return (vertices_[edge[1]] - vertices_[edge[0]]).norm(); }

  double height(const Corners& corners) const {
    const Vector3d &a = vertices_[corners[0]], &b = vertices_[corners[1]], &c = vertices_[corners[2]];
    const double longest = std::max({(b - a).norm(), (c - b).norm(), (a - c).norm()});
    return longest > 0.0 ? (b - a).cross(c - a).norm() / longest : 0.0;
  }

  void weld(std::vector<Facet>& facets) const {
    const std::vector<OpenEdge> open = openEdges(facets);
    std::unordered_map<std::uint32_t, double> reach;  // of each vertex on open edges
    for (const OpenEdge& edge : open) {
      const double here = cracks_ ? std::min(tolerance_, kCrackOfEdge * length(edge)) : tolerance_;
      for (const std::uint32_t vertex : edge) {
        const auto known = reach.try_emplace(vertex, here).first;
        known->second = std::min(known->second, here);
      }
    }
    Cubes cubes(tolerance_);
    std::unordered_map<std::uint32_t, std::uint32_t> welded;  // onto a vertex that stays
    for (const std::uint32_t vertex : verticesOf(open)) {
      const Vector3d& at = vertices_[vertex];
      std::uint32_t onto = vertex;
      double nearest = std::numeric_limits<double>::infinity();
      cubes.forEachNear(at, [&](std::uint32_t other) {
        const double apart = (vertices_[other] - at).norm();
        if (apart > std::min(reach[vertex], reach[other]) || apart >= nearest) return;
        nearest = apart;
        onto = other;
      });
      if (onto == vertex) {
        cubes.add(vertex, at);
      } else {
        welded[vertex] = onto;
      }
    }
    if (welded.empty()) return;
    for (Facet& facet : facets) {
      for (std::uint32_t& corner : facet.corners) {
        const auto found = welded.find(corner);
        if (found != welded.end()) corner = found->second;
      }
    }
  }

  static void dropCopies(std::vector<Facet>& facets) {
    const std::vector<std::uint32_t> first = firstOfSame(cornersOf(facets));
    std::vector<Facet> kept;
    for (std::uint32_t i = 0; i < facets.size(); ++i) {
      if (first[i] != i) facets[first[i]].was_doubled = true;
    }
    for (std::uint32_t i = 0; i < facets.size(); ++i) {
      if (first[i] == i) kept.push_back(facets[i]);
    }
    facets = std::move(kept);
  }

  // Facets that were there several times hang together in regions. One that leaves more edges open than there
  // would be without it is a wall between two solids, and bounds nothing.
  static void dropWalls(std::vector<Facet>& facets) {
    if (std::none_of(facets.begin(), facets.end(), [](const Facet& facet) { return facet.was_doubled; }))
      return;
    const std::vector<FacetEdge> edges = edgesOf(cornersOf(facets));
    const auto doubled = [&](const FacetEdge& edge) { return facets[edge.facet].was_doubled; };
    UnionFind regions(facets.size());
    forEachEdge(edges, [&](const FacetEdge* begin, const FacetEdge* end) {
      const FacetEdge* before = nullptr;
      for (const FacetEdge* edge = begin; edge < end; ++edge) {
        if (!doubled(*edge)) continue;
        if (before != nullptr) regions.join(before->facet, edge->facet);
        before = edge;
      }
    });
    std::vector<int> opens(facets.size(), 0);  // edges of a region that are open with it, less those without
    forEachEdge(edges, [&](const FacetEdge* begin, const FacetEdge* end) {
      if (std::count_if(begin, end, doubled) % 2 == 0) return;
      const FacetEdge* of = std::find_if(begin, end, doubled);
      opens[regions.of(of->facet)] += (end - begin) % 2 != 0 ? 1 : -1;
    });
    std::vector<Facet> kept;
    for (std::uint32_t i = 0; i < facets.size(); ++i) {
      if (!facets[i].was_doubled || opens[regions.of(i)] <= 0) kept.push_back(facets[i]);
    }
    facets = std::move(kept);
  }

  // Edges divided at the vertices of other open edges that lie on them.
  std::vector<Facet> divided(const std::vector<Facet>& facets) const {
    const std::vector<OpenEdge> open = openEdges(facets);
    if (open.empty()) return facets;
    TriangleMesh lines;  // edges as triangles, for the hierarchy
    lines.vertices = vertices_;
    for (const auto& [a, b] : open) lines.triangles.push_back({a, b, b});
    const TriangleTree tree(lines);
    struct Cut {
      double along;
      std::uint32_t vertex;
      bool operator<(const Cut& other) const { return along < other.along; }
    };
    std::map<OpenEdge, std::vector<Cut>> cuts;
    std::vector<std::uint32_t> nodes;
    for (const std::uint32_t vertex : verticesOf(open)) {
      const Vector3d& at = vertices_[vertex];
      nodes.assign(1, 0);
      while (!nodes.empty()) {
        const TriangleTree::Node& node = tree.nodes[nodes.back()];
        nodes.pop_back();
        if (squaredGap(node.box, at) > tolerance_ * tolerance_) continue;
        if (node.count == 0) {
          nodes.push_back(node.first);
          nodes.push_back(node.first + 1);
        }
        for (std::uint32_t i = node.first; i < node.first + node.count; ++i) {
          const OpenEdge& edge = open[tree.number[i]];
          if (edge[0] == vertex || edge[1] == vertex) continue;
          const Vector3d &a = vertices_[edge[0]], way = vertices_[edge[1]] - a;
          const double squared = way.squaredNorm(), along = (at - a).dot(way) / squared;
          const double reach = cracks_ ? std::min(tolerance_, kCrackOfEdge * std::sqrt(squared)) : tolerance_;
          if (!(along > 0.0 && along < 1.0) || (at - a - along * way).norm() > reach) continue;
          cuts[edge].push_back({along, vertex});
        }
      }
    }
    if (cuts.empty()) return facets;
    for (auto& [edge, at] : cuts) std::sort(at.begin(), at.end());

    std::vector<Facet> result;
    result.reserve(facets.size() + cuts.size());
    struct Piece {
      Corners corners;
      std::array<bool, 3> whole_edge;  // from each corner to the next: the facet's own, not yet divided
    };
    std::vector<Piece> waiting;
    for (const Facet& facet : facets) {
      waiting.assign(1, {facet.corners, {true, true, true}});
      while (!waiting.empty()) {
        const Piece here = waiting.back();
        waiting.pop_back();
        bool whole = true;
        for (std::size_t i = 0; i < 3 && whole; ++i) {
          if (!here.whole_edge[i]) continue;
          const std::uint32_t from = here.corners[i], to = here.corners[(i + 1) % 3],
                              across = here.corners[(i + 2) % 3];
          const auto found = cuts.find({std::min(from, to), std::max(from, to)});
          if (found == cuts.end()) continue;
          std::vector<std::uint32_t> line = {from};
          for (const Cut& cut : found->second) {
            if (cut.vertex != across) line.push_back(cut.vertex);
          }
          if (line.size() == 1) continue;
          if (from > to) std::reverse(line.begin() + 1, line.end());
          line.push_back(to);
          const std::size_t last = line.size() - 2;
          for (std::size_t k = 0; k <= last; ++k) {
            waiting.push_back(
                {{line[k], line[k + 1], across},
                 {false, k == last && here.whole_edge[(i + 1) % 3], k == 0 && here.whole_edge[(i + 2) % 3]}});
          }
          whole = false;
        }
        if (whole && !isCollapsed(here.corners)) {
          result.push_back({here.corners, facet.from, facet.was_doubled});
        }
      }
    }
    return result;
  }

  const std::vector<Vector3d>& vertices_;
  double tolerance_;
  bool cracks_;
};

// Numbers that are the same for vertices at the same position; fills in these positions.
std::vector<std::uint32_t> positionNumbers(const std::vector<Vector3d>& vertices,
                                           std::vector<Vector3d>& positions) {
  std::vector<std::uint32_t> order(vertices.size());
  std::iota(order.begin(), order.end(), 0u);
  const auto before = [&](std::uint32_t i, std::uint32_t j) {
    const Vector3d &a = vertices[i], &b = vertices[j];
    return std::lexicographical_compare(a.data(), a.data() + 3, b.data(), b.data() + 3);
  };
  std::sort(order.begin(), order.end(), before);
  std::vector<std::uint32_t> number(vertices.size());
  for (std::size_t i = 0; i < order.size(); ++i) {
    if (i == 0 || before(order[i - 1], order[i])) positions.push_back(vertices[order[i]]);
    number[order[i]] = static_cast<std::uint32_t>(positions.size() - 1);
  }
  return number;
}

}  // namespace

WeldedSurface::WeldedSurface(const TriangleMesh& mesh) {
  const std::vector<std::uint32_t> position = positionNumbers(mesh.vertices, vertices);
  facets.reserve(mesh.triangles.size());
  for (const auto& [a, b, c] : mesh.triangles) facets.push_back({position[a], position[b], position[c]});
  source.resize(facets.size());
  std::iota(source.begin(), source.end(), 0u);

  const FacetGroups exact(facets);
  if (std::find(exact.closed.begin(), exact.closed.end(), 0) == exact.closed.end()) return;
  Box box;
  for (const auto& triangle : mesh.triangles) {
    for (const std::uint32_t vertex : triangle) box.add(mesh.vertices[vertex]);
  }
  const double diagonal = (box.high - box.low).matrix().norm();
  const double largest = box.low.abs().max(box.high.abs()).maxCoeff();
  if (!(diagonal > 0.0)) return;

  mended = true;
  std::vector<Corners> kept;
  std::vector<std::uint32_t> kept_source;
  const auto keep = [&](const Corners& corners, std::uint32_t from) {
    kept.push_back(corners);
    kept_source.push_back(from);
  };
  std::vector<Facet> open;
  for (std::uint32_t i = 0; i < facets.size(); ++i) {
    const std::uint32_t group = exact.group[i];
    if (group != FacetGroups::kNone && exact.closed[group]) {
      keep(facets[i], i);
    } else if (group != FacetGroups::kNone) {
      open.push_back({facets[i], i});
    }
  }
  const Mender rounding(vertices, kRounding * diagonal + kFloat * largest, false);
  open = rounding.welded(std::move(open));
  const std::vector<Facet> whole = rounding.joined(open);
  const FacetGroups rounded(cornersOf(whole));
  const auto stillOpen = [&](std::uint32_t i) {
    return rounded.group[i] != FacetGroups::kNone && !rounded.closed[rounded.group[i]];
  };
  std::vector<std::uint8_t> torn(open.size(), 0);
  for (std::uint32_t i = 0; i < whole.size(); ++i) {
    if (stillOpen(i)) torn[whole[i].from] = 1;
  }
  // Of those once more, before edges were divided: cracks leave vertices beside each other on an edge.
  std::vector<Facet> cracked;
  for (std::uint32_t i = 0; i < open.size(); ++i) {
    if (torn[i]) cracked.push_back({open[i].corners, i, open[i].was_doubled});
  }
  const Mender filling(vertices, kCrack * diagonal, true);
  cracked = filling.welded(std::move(cracked));
  const std::vector<Facet> filled = filling.joined(cracked);
  const FacetGroups groups(cornersOf(filled));
  for (std::uint32_t i = 0; i < filled.size(); ++i) {
    const std::uint32_t group = groups.group[i];
    if (group == FacetGroups::kNone || !groups.closed[group]) continue;
    const std::uint32_t number = cracked[filled[i].from].from;
    keep(filled[i].corners, open[number].from);
    torn[number] = 0;
  }
  for (std::uint32_t i = 0; i < whole.size(); ++i) {
    if (rounded.group[i] == FacetGroups::kNone || (stillOpen(i) && !torn[whole[i].from])) continue;
    keep(whole[i].corners, open[whole[i].from].from);
  }
  facets = std::move(kept);
  source = std::move(kept_source);
}

}  // namespace cable_variation
