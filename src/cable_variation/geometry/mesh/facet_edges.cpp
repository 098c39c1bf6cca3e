#include <cable_variation/geometry/mesh/facet_edges.h>

#include <algorithm>
#include <numeric>
#include <utility>

namespace cable_variation {

std::vector<FacetEdge> edgesOf(const std::vector<Corners>& facets,
                               const std::vector<std::uint8_t>& left_out) {
  std::vector<FacetEdge> edges;
  edges.reserve(3 * facets.size());
  for (std::uint32_t i = 0; i < facets.size(); ++i) {
    if (isCollapsed(facets[i]) || (!left_out.empty() && left_out[i])) continue;
    const auto& [a, b, c] = facets[i];
    for (const auto& [from, to] : {std::pair(a, b), std::pair(b, c), std::pair(c, a)}) {
      edges.push_back({std::min(from, to), std::max(from, to), i, from < to});
    }
  }
  std::sort(edges.begin(), edges.end(), [](const FacetEdge& x, const FacetEdge& y) {
    return std::array{x.low, x.high, x.facet} < std::array{y.low, y.high, y.facet};
  });
  return edges;
}

UnionFind::UnionFind(std::size_t count) : parent_(count) { std::iota(parent_.begin(), parent_.end(), 0u); }

std::vector<std::uint32_t> firstOfSame(const std::vector<Corners>& facets) {
  std::vector<std::array<std::uint32_t, 4>> sorted;
  sorted.reserve(facets.size());
  for (std::uint32_t i = 0; i < facets.size(); ++i) {
    Corners key = facets[i];
    std::sort(key.begin(), key.end());
    sorted.push_back({key[0], key[1], key[2], i});
  }
  std::sort(sorted.begin(), sorted.end());
  std::vector<std::uint32_t> first(facets.size());
  for (std::size_t i = 0, start = 0; i < sorted.size(); ++i) {
    if (!std::equal(sorted[i].begin(), sorted[i].begin() + 3, sorted[start].begin())) start = i;
    first[sorted[i][3]] = sorted[start][3];
  }
  return first;
}

FacetGroups::FacetGroups(const std::vector<Corners>& facets)
    : group(facets.size(), kNone), again(facets.size(), 0) {
  const std::vector<std::uint32_t> first = firstOfSame(facets);
  std::vector<std::uint32_t> copies(facets.size(), 0);  // of the first of the same
  for (const std::uint32_t of : first) ++copies[of];

  UnionFind together(facets.size());
  edges = edgesOf(facets);
  forEachEdge(edges, [&](const FacetEdge* begin, const FacetEdge* end) {
    for (const FacetEdge* edge = begin + 1; edge < end; ++edge) together.join(begin->facet, edge->facet);
  });
  std::vector<std::uint8_t> doubled(facets.size(), 1);  // every facet is there an even number of times
  for (std::uint32_t i = 0; i < facets.size(); ++i) {
    if (copies[first[i]] % 2 != 0) doubled[together.of(i)] = 0;
  }
  bool any = false;
  for (std::uint32_t i = 0; i < facets.size(); ++i) {
    again[i] = doubled[together.of(i)] && first[i] != i;
    any = any || again[i];
  }
  if (any) edges = edgesOf(facets, again);

  std::vector<std::uint32_t> number(facets.size(), kNone);
  forEachEdge(edges, [&](const FacetEdge* begin, const FacetEdge* end) {
    std::uint32_t& here = number[together.of(begin->facet)];
    if (here == kNone) {
      here = static_cast<std::uint32_t>(closed.size());
      closed.push_back(1);
    }
    if ((end - begin) % 2 != 0) closed[here] = 0;
    for (const FacetEdge* edge = begin; edge < end; ++edge) group[edge->facet] = here;
  });
}

}  // namespace cable_variation
