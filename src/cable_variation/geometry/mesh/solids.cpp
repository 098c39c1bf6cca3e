#include <cable_variation/geometry/mesh/solids.h>

#include <algorithm>
#include <array>
#include <numeric>

#include <cable_variation/geometry/mesh/crossing_ray.h>
#include <cable_variation/geometry/mesh/oriented_facets.h>
#include <cable_variation/geometry/mesh/welded_surface.h>

namespace cable_variation {
namespace {

using Eigen::Vector3d;

double sixVolumes(const std::array<Vector3d, 3>& triangle, const Vector3d& origin) {
  const Vector3d a = triangle[0] - origin, b = triangle[1] - origin, c = triangle[2] - origin;
  return a.x() * (b.y() * c.z() - b.z() * c.y()) + a.y() * (b.z() * c.x() - b.x() * c.z()) +
         a.z() * (b.x() * c.y() - b.y() * c.x());
}

// A shell while it is not known yet what it bounds.
struct Draft {
  std::vector<std::uint32_t> members;  // of the boundary's facets
  double volume = 0.0;                 // six times, positive: faces outwards
  bool facing = false;
};

}  // namespace

Solids::Solids(const TriangleMesh& mesh) {
  WeldedSurface surface(mesh);
  const FacetGroups groups(surface.facets);
  OrientedFacets oriented(surface.vertices, surface.facets, groups);
  std::vector<Corners> facets = std::move(oriented.facets);
  source = std::move(surface.source);
  std::vector<Vector3d> vertices = std::move(surface.vertices);

  shell.assign(facets.size(), kNone);
  std::vector<std::uint32_t> shell_of_group(groups.closed.size(), kNone);
  std::vector<Draft> drafts;
  std::vector<std::uint8_t> not_open(facets.size(), 1);
  bool any_open = false;
  for (std::uint32_t i = 0; i < facets.size(); ++i) {
    const std::uint32_t group = groups.group[i];
    if (group == FacetGroups::kNone) continue;
    if (!groups.closed[group]) {
      not_open[i] = 0;
      any_open = true;
      continue;
    }
    if (shell_of_group[group] == kNone) {
      shell_of_group[group] = static_cast<std::uint32_t>(drafts.size());
      drafts.emplace_back();
      drafts.back().facing = oriented.facing[group] != 0;
    }
    shell[i] = shell_of_group[group];
    drafts[shell[i]].members.push_back(i);
  }
  if (any_open) {
    open = static_cast<std::uint32_t>(drafts.size());
    drafts.emplace_back();
    drafts.back().facing = true;
    const RimCaps rims(vertices, facets, not_open);
    rim_length = rims.rim_length;
    forEachEdge(edgesOf(facets, not_open), [&](const FacetEdge* first, const FacetEdge* last) {
      rim_edges += (last - first) % 2 != 0 ? 1 : 0;
    });
    for (std::uint32_t i = 0; i < not_open.size(); ++i) {
      if (not_open[i]) continue;
      shell[i] = *open;
      drafts.back().members.push_back(i);
    }
    vertices.insert(vertices.end(), rims.middles.begin(), rims.middles.end());
    for (std::size_t i = 0; i < rims.facets.size(); ++i) {
      drafts.back().members.push_back(static_cast<std::uint32_t>(facets.size()));
      facets.push_back(rims.facets[i]);
      source.push_back(source[rims.beside[i]]);
      shell.push_back(*open);
      const auto first = static_cast<std::uint32_t>(caps.vertices.size());
      for (const std::uint32_t corner : rims.facets[i]) caps.vertices.push_back(vertices[corner]);
      caps.triangles.push_back({first, first + 1, first + 2});
    }
  }

  shell_of_triangle.assign(mesh.triangles.size(), kNone);
  for (std::uint32_t i = 0; i < shell.size(); ++i) {
    if (shell[i] != kNone) shell_of_triangle[source[i]] = shell[i];
  }
  const auto points = [&](std::uint32_t facet) {
    const auto& [a, b, c] = facets[facet];
    return std::array{vertices[a], vertices[b], vertices[c]};
  };
  shells.resize(drafts.size());
  for (std::size_t k = 0; k < drafts.size(); ++k) {
    const Vector3d origin = points(drafts[k].members.front())[0];
    for (const std::uint32_t i : drafts[k].members) {
      for (const Vector3d& corner : points(i)) shells[k].box.add(corner);
      drafts[k].volume += sixVolumes(points(i), origin);
    }
  }

  // An inward shell belongs to the smallest outward one around it.
  std::vector<std::uint32_t> around(shells.size(), kNone);
  for (std::size_t k = 0; k < shells.size(); ++k) {
    if (!(drafts[k].facing && drafts[k].volume < 0.0)) continue;
    const Vector3d inside = points(drafts[k].members.front())[0];
    for (std::uint32_t outer = 0; outer < shells.size(); ++outer) {
      if (outer == k || !(drafts[outer].facing && drafts[outer].volume > -drafts[k].volume) ||
          !shells[outer].box.contains(inside)) {
        continue;
      }
      if (around[k] != kNone && drafts[around[k]].volume < drafts[outer].volume) continue;
      const bool within = oddCrossings(inside, [&](const CrossingRay& ray) {
        int crossings = 0;
        for (const std::uint32_t i : drafts[outer].members) {
          const CrossingRay::Answer answer = ray.crosses(points(i), facets[i]);
          if (answer == CrossingRay::Answer::unclear) return CrossingRay::kUnclear;
          crossings += answer != CrossingRay::Answer::no;
        }
        return crossings;
      });
      if (within) around[k] = outer;
    }
  }
  for (std::size_t k = 0; k < shells.size(); ++k) {
    if (around[k] == kNone) shells[k].solid = count++;
  }
  for (std::size_t k = 0; k < shells.size(); ++k) {
    if (around[k] == kNone) continue;
    shells[k].cavity = true;
    shells[k].solid = shells[around[k]].solid;
  }
  if (!surface.mended) {
    corners = std::move(surface.facets);
    return;
  }
  // Only what bounds something.
  boundary.vertices = std::move(vertices);
  std::size_t kept = 0;
  for (std::size_t i = 0; i < facets.size(); ++i) {
    if (shell[i] == kNone) continue;
    facets[kept] = facets[i];
    source[kept] = source[i];
    shell[kept] = shell[i];
    ++kept;
  }
  facets.resize(kept);
  source.resize(kept);
  shell.resize(kept);
  boundary.triangles = facets;
  corners = std::move(facets);
}

}  // namespace cable_variation
