#include <cable_variation/geometry/mesh/oriented_facets.h>

#include <algorithm>
#include <utility>

#include <Eigen/Geometry>

namespace cable_variation {
namespace {

using Eigen::Vector3d;

struct Neighbour {
  std::uint32_t facet;
  bool same_way;  // both face the same way
};

}  // namespace

OrientedFacets::OrientedFacets(const std::vector<Vector3d>& vertices, const std::vector<Corners>& from,
                               const FacetGroups& groups)
    : facets(from), facing(groups.closed.size(), 1) {
  constexpr std::uint32_t kNone = FacetGroups::kNone;
  std::vector<std::array<Neighbour, 3>> neighbours(from.size(),
                                                   {{{kNone, true}, {kNone, true}, {kNone, true}}});
  std::vector<std::uint8_t> found(from.size(), 0);
  forEachEdge(groups.edges, [&](const FacetEdge* first, const FacetEdge* last) {
    if (last - first != 2) {
      facing[groups.group[first->facet]] = 0;
      return;
    }
    const std::uint32_t a = first->facet, b = first[1].facet;
    const bool same_way = first->forward != first[1].forward;
    neighbours[a][found[a]++] = {b, same_way};
    neighbours[b][found[b]++] = {a, same_way};
  });

  const auto area = [&](std::uint32_t i) {
    const Vector3d& a = vertices[from[i][0]];
    return (vertices[from[i][1]] - a).cross(vertices[from[i][2]] - a).norm();
  };
  constexpr std::uint8_t kNew = 0, kKept = 1, kTurned = 2;
  std::vector<std::uint8_t> state(from.size(), kNew);
  std::vector<std::uint32_t> patch, open;
  for (std::uint32_t seed = 0; seed < from.size(); ++seed) {
    if (state[seed] != kNew || groups.group[seed] == kNone) continue;
    patch.clear();
    open.assign(1, seed);
    state[seed] = kKept;
    double kept = 0.0, turned = 0.0;
    bool agree = true;
    while (!open.empty()) {
      const std::uint32_t here = open.back();
      open.pop_back();
      patch.push_back(here);
      (state[here] == kKept ? kept : turned) += area(here);
      for (const Neighbour& neighbour : neighbours[here]) {
        if (neighbour.facet == kNone) continue;
        const std::uint8_t other = state[here] == kKept ? kTurned : kKept;
        const std::uint8_t wanted = neighbour.same_way ? state[here] : other;
        if (state[neighbour.facet] == kNew) {
          state[neighbour.facet] = wanted;
          open.push_back(neighbour.facet);
        } else if (state[neighbour.facet] != wanted) {
          agree = false;  // a one-sided surface
        }
      }
    }
    if (!agree) {
      facing[groups.group[seed]] = 0;
      continue;
    }
    const std::uint8_t turns = turned > kept ? kKept : kTurned;
    for (const std::uint32_t i : patch) {
      if (state[i] == turns) std::swap(facets[i][1], facets[i][2]);
    }
  }
}

RimCaps::RimCaps(const std::vector<Vector3d>& vertices, const std::vector<Corners>& of,
                 const std::vector<std::uint8_t>& left_out) {
  struct RimEdge {
    std::uint32_t from, to, facet;  // as the cap runs along it
  };
  std::vector<RimEdge> rim;
  const std::vector<FacetEdge> edges = edgesOf(of, left_out);
  forEachEdge(edges, [&](const FacetEdge* first, const FacetEdge* last) {
    int forward = 0;
    for (const FacetEdge* edge = first; edge < last; ++edge) forward += edge->forward ? 1 : -1;
    for (; forward > 0; --forward) rim.push_back({first->high, first->low, first->facet});
    for (; forward < 0; ++forward) rim.push_back({first->low, first->high, first->facet});
  });
  if (rim.empty()) return;

  UnionFind loops(vertices.size());
  for (const RimEdge& edge : rim) loops.join(edge.from, edge.to);
  struct Loop {
    Vector3d sum = Vector3d::Zero();
    double length = 0.0;
    std::uint32_t number = 0;
  };
  std::vector<std::uint32_t> loop_of(vertices.size(), FacetGroups::kNone);
  std::vector<Loop> found;
  for (const RimEdge& edge : rim) {
    std::uint32_t& number = loop_of[loops.of(edge.from)];
    if (number == FacetGroups::kNone) {
      number = static_cast<std::uint32_t>(found.size());
      found.emplace_back();
    }
    const Vector3d &a = vertices[edge.from], &b = vertices[edge.to];
    const double length = (b - a).norm();
    found[number].sum += 0.5 * length * (a + b);
    found[number].length += length;
  }
  for (Loop& loop : found) {
    loop.number = static_cast<std::uint32_t>(vertices.size() + middles.size());
    middles.emplace_back(loop.sum / loop.length);
    rim_length += loop.length;
  }
  for (const RimEdge& edge : rim) {
    facets.push_back({edge.from, edge.to, found[loop_of[loops.of(edge.from)]].number});
    beside.push_back(edge.facet);
  }
}

}  // namespace cable_variation
