#pragma once

#include <array>
#include <cstdint>
#include <vector>

namespace cable_variation {

/// Three corners of a triangle, as numbers of vertices.
using Corners = std::array<std::uint32_t, 3>;

/// An edge of a facet between two corners, seen without direction.
struct FacetEdge {
  std::uint32_t low = 0, high = 0;  ///< corners
  std::uint32_t facet = 0;
  bool forward = false;  ///< the facet runs from low to high

  bool sameAs(const FacetEdge& other) const { return low == other.low && high == other.high; }
};

inline bool isCollapsed(const Corners& corners) {
  return corners[0] == corners[1] || corners[1] == corners[2] || corners[2] == corners[0];
}

/// The edges of facets, those of the same two corners after each other. Facets with a corner twice have none.
/// @param left_out facets that do not count; empty: all do
std::vector<FacetEdge> edgesOf(const std::vector<Corners>& facets,
                               const std::vector<std::uint8_t>& left_out = {});

/// Calls visit(first, last) for the facets that meet at each edge.
template <typename Visit>
void forEachEdge(const std::vector<FacetEdge>& edges, Visit&& visit) {
  for (std::size_t i = 0, end; i < edges.size(); i = end) {
    for (end = i + 1; end < edges.size() && edges[end].sameAs(edges[i]);) ++end;
    visit(edges.data() + i, edges.data() + end);
  }
}

/// Things that hang together.
class UnionFind {
 public:
  explicit UnionFind(std::size_t count);
  std::uint32_t of(std::uint32_t i) {
    while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
    return i;
  }
  void join(std::uint32_t i, std::uint32_t j) { parent_[of(i)] = of(j); }

 private:
  std::vector<std::uint32_t> parent_;
};

/// Facets that hang together by edges, and whether they close: an even number of them meets at every edge. A
/// group with every facet there twice, once for each side, counts once.
struct FacetGroups {
  static constexpr std::uint32_t kNone = static_cast<std::uint32_t>(-1);

  std::vector<std::uint32_t> group;  ///< of each facet; kNone: it has a corner twice, or is there again
  std::vector<std::uint8_t> closed;  ///< of each group
  std::vector<FacetEdge> edges;      ///< of the facets that count
  std::vector<std::uint8_t> again;   ///< of each facet: it is the other side of one that counts

  explicit FacetGroups(const std::vector<Corners>& facets);
};

/// Facets with the same three corners, whichever way they face: the number of the first such one.
std::vector<std::uint32_t> firstOfSame(const std::vector<Corners>& facets);

}  // namespace cable_variation
