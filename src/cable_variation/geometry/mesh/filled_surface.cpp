#include <cable_variation/geometry/mesh/filled_surface.h>

#include <algorithm>
#include <numeric>
#include <vector>

#include <Eigen/Geometry>

#include <cable_variation/geometry/mesh/box.h>
#include <cable_variation/geometry/mesh/crossing_ray.h>

namespace cable_variation {
namespace {

struct Component {
  std::vector<std::uint32_t> triangles;
  Box box;
  double volume = 0.0;  // [m³]; negative: a void's, whose outward side is inside
  bool kept = true;
};

std::vector<Component> componentsOf(const TriangleMesh& mesh) {
  std::vector<std::uint32_t> parent(mesh.vertices.size());
  std::iota(parent.begin(), parent.end(), 0U);
  const auto root = [&](std::uint32_t vertex) {
    while (parent[vertex] != vertex) vertex = parent[vertex] = parent[parent[vertex]];
    return vertex;
  };
  for (const auto& [a, b, c] : mesh.triangles) {
    const std::uint32_t lowest = std::min({root(a), root(b), root(c)});
    parent[root(a)] = parent[root(b)] = parent[root(c)] = lowest;
  }

  std::vector<Component> components;
  std::vector<std::uint32_t> number(mesh.vertices.size(), static_cast<std::uint32_t>(-1));
  for (std::uint32_t triangle = 0; triangle < mesh.triangles.size(); ++triangle) {
    const auto& corners = mesh.triangles[triangle];
    const std::uint32_t first = root(corners[0]);
    if (number[first] == static_cast<std::uint32_t>(-1)) {
      number[first] = static_cast<std::uint32_t>(components.size());
      components.emplace_back();
    }
    Component& component = components[number[first]];
    component.triangles.push_back(triangle);
    std::array<Eigen::Vector3d, 3> from_first;
    for (std::size_t i = 0; i < 3; ++i) {
      component.box.add(mesh.vertices[corners[i]]);
      from_first[i] = mesh.vertices[corners[i]] - mesh.vertices[first];
    }
    component.volume += from_first[0].dot(from_first[1].cross(from_first[2])) / 6.0;
  }
  return components;
}

bool isWithin(const TriangleMesh& mesh, const Component& inner, const Component& outer) {
  if (!outer.box.contains(inner.box.low) || !outer.box.contains(inner.box.high)) return false;
  const Eigen::Vector3d& point = mesh.vertices[mesh.triangles[inner.triangles.front()][0]];
  return oddCrossings(point, [&](const CrossingRay& ray) {
    int crossings = 0;
    for (const std::uint32_t triangle : outer.triangles) {
      const auto& [a, b, c] = mesh.triangles[triangle];
      switch (ray.crosses({mesh.vertices[a], mesh.vertices[b], mesh.vertices[c]}, {a, b, c})) {
        case CrossingRay::Answer::leaves:
        case CrossingRay::Answer::enters:
          ++crossings;
          break;
        case CrossingRay::Answer::unclear:
          return CrossingRay::kUnclear;
        case CrossingRay::Answer::no:
          break;
      }
    }
    return crossings;
  });
}

}  // namespace

FilledSurface filledSurface(const TriangleMesh& mesh) {
  FilledSurface filled;
  std::vector<Component> components = componentsOf(mesh);
  for (Component& component : components) {
    if (component.volume > 0.0) continue;
    component.kept = false;
    ++filled.filled_voids;
  }
  for (Component& inner : components) {
    if (inner.volume <= 0.0) continue;
    inner.kept = std::none_of(components.begin(), components.end(), [&](const Component& outer) {
      return &outer != &inner && outer.volume > inner.volume && isWithin(mesh, inner, outer);
    });
  }

  constexpr std::uint32_t kUnused = static_cast<std::uint32_t>(-1);
  std::vector<std::uint32_t> number(mesh.vertices.size(), kUnused);
  for (const Component& component : components) {
    if (!component.kept) continue;
    ++filled.components;
    for (const std::uint32_t triangle : component.triangles) {
      std::array<std::uint32_t, 3> corners = mesh.triangles[triangle];
      for (std::uint32_t& corner : corners) {
        if (number[corner] == kUnused) {
          number[corner] = static_cast<std::uint32_t>(filled.mesh.vertices.size());
          filled.mesh.vertices.push_back(mesh.vertices[corner]);
        }
        corner = number[corner];
      }
      filled.mesh.triangles.push_back(corners);
    }
  }
  return filled;
}

}  // namespace cable_variation
